#pragma once

#include "engine/net/entry/key_deriver.h"
#include "engine/net/entry/session_secrets.h"
#include "engine/net/secure/host_transport.h"

#include <mutex>
#include <set>

namespace carina
{

/// Access control of a session: checks what peers prove against the session's secrets. Used on the
/// node's thread, except keyOf. The keys of the codes are derived once each, on another thread.
class HostAccess
{
public:
    /// @param secrets file; empty: in memory only @returns the errors of SessionSecrets::open.
    [[nodiscard]] static Result<std::unique_ptr<HostAccess>>
    open(const std::filesystem::path& secrets, const std::string& sessionId, DeriveKey derive);

    [[nodiscard]] const std::string& sessionId() const { return m_secrets.sessionId(); }
    [[nodiscard]] const JoinCodes& codes() const { return m_secrets.codes(); }
    /// Why a code cannot be used.
    [[nodiscard]] const std::optional<Error>& fault() const { return m_fault; }
    /// The key that a peer with this identity must have. May be called from any thread.
    [[nodiscard]] HostTransport::KeyAnswer keyOf(const PskIdentity& identity) const;

    /// Keeps the secrets beside the new file of the store from now on. @returns FileUnwritable.
    [[nodiscard]] Result<void> moveBeside(const std::filesystem::path& store);

    /// Gives a role another code; who has not come in with the old one is out. @returns
    /// FileUnwritable; then nothing has changed.
    [[nodiscard]] Result<void> changeCode(Role role);

    /// Whether the key of this role's code is still being derived.
    [[nodiscard]] bool isDeriving(Role role) const;

    /// Stores what a peer proved, as long as it is connected.
    void connected(PeerAddress peer, const Credential& who);
    void disconnected(PeerAddress peer);
    /// @returns NotPermitted for a peer that proved another role, or another participant;
    ///          UsedElsewhere for one that was displaced; NameTaken
    ///          for one that proved a role by its code, where the participant has a token: once
    ///          there is one, nothing else proves a return.
    [[nodiscard]] Result<void> check(PeerAddress peer, Role role, ParticipantId participant) const;
    /// From now on this peer is that participant, and nobody else.
    void admitted(PeerAddress peer, ParticipantId participant);
    /// Whether the peer proved which participant it is: by a token, or by coming in before.
    [[nodiscard]] bool isProven(PeerAddress peer) const;

    /// Another program proved the participant of this peer, too: this one proves nothing any more.
    void displace(PeerAddress peer);
    /// Replaces the token of a participant. @returns FileUnwritable; then it is unchanged.
    [[nodiscard]] Result<AccessKey> replaceToken(Role role, ParticipantId participant);
    /// A participant has no token any more. @returns FileUnwritable.
    [[nodiscard]] Result<void> revokeToken(Role role, ParticipantId participant);

    /// The token with which an admitted participant can join again. @returns FileUnwritable.
    [[nodiscard]] Result<AccessKey> issueToken(PeerAddress peer, ParticipantId participant);

private:
    HostAccess(SessionSecrets secrets, DeriveKey derive);
    void deriveMissing();
    void derive(Role role);

    mutable std::mutex m_mutex; // over m_secrets: it changes on the node's thread
    SessionSecrets m_secrets;
    std::map<PeerAddress, Credential> m_peers;
    std::set<PeerAddress> m_displaced;
    std::optional<Error> m_fault;
    KeyDeriver m_deriver;
};

} // namespace carina
