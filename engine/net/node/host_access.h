#pragma once

#include "engine/net/entry/key_deriver.h"
#include "engine/net/entry/session_secrets.h"
#include "engine/net/secure/host_transport.h"

#include <mutex>

namespace carina
{

/// Who may come into a session and as whom: holds the session's secrets against what peers prove.
/// Lives on the node's thread, but for keyOf; the codes' keys are derived on another one, each
/// once.
class HostAccess
{
public:
    /// @param secrets the file, empty for none @returns what SessionSecrets::open does.
    [[nodiscard]] static Result<std::unique_ptr<HostAccess>>
    open(const std::filesystem::path& secrets, const std::string& sessionId, DeriveKey derive);

    [[nodiscard]] const std::string& sessionId() const { return m_secrets.sessionId(); }
    [[nodiscard]] const JoinCodes& codes() const { return m_secrets.codes(); }
    /// Why a code opens nothing.
    [[nodiscard]] const std::optional<Error>& fault() const { return m_fault; }
    /// The key that a peer with this identity must have. May be asked from any thread.
    [[nodiscard]] HostTransport::KeyAnswer keyOf(const PskIdentity& identity) const;

    /// What a peer proved to be, for as long as it is connected.
    void connected(PeerAddress peer, const Credential& who);
    void disconnected(PeerAddress peer);
    /// @returns NotPermitted for a peer that proved another role, or to be somebody else.
    [[nodiscard]] Result<void> check(PeerAddress peer, Role role, ParticipantId participant) const;

    /// The key by which this participant, who was let in, may come back. @returns FileUnwritable.
    [[nodiscard]] Result<AccessKey> issueToken(PeerAddress peer, ParticipantId participant);

private:
    HostAccess(SessionSecrets secrets, DeriveKey derive);
    void deriveMissing();

    mutable std::mutex m_mutex; // over m_secrets: it changes on the node's thread
    SessionSecrets m_secrets;
    std::map<PeerAddress, Credential> m_peers;
    std::optional<Error> m_fault;
    KeyDeriver m_deriver;
};

} // namespace carina
