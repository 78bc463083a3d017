#pragma once

#include "engine/net/entry/key_deriver.h"
#include "engine/net/entry/session_secrets.h"
#include "engine/net/secure/host_transport.h"

#include <functional>
#include <mutex>
#include <optional>
#include <set>

namespace carina
{

/// Access control of a session: checks what peers prove against the session's secrets. Used on the
/// node's thread, except keyOf. The keys of the codes are derived once each, on another thread.
///
/// A change holds at once. It is to be written by handOver(), before anybody hears of it, and then
/// to be confirmed by stored() or undone by giveUp().
class HostAccess
{
public:
    /// @param secrets file; empty: in memory only @returns the errors of SessionSecrets::open.
    [[nodiscard]] static Result<std::unique_ptr<HostAccess>>
    open(const std::filesystem::path& secrets, const std::string& sessionId, DeriveKey derive);

    [[nodiscard]] const std::string& sessionId() const { return m_secrets.sessionId(); }
    /// The codes that are stored.
    [[nodiscard]] const JoinCodes& codes() const { return m_stored.codes(); }
    /// Why a code cannot be used.
    [[nodiscard]] std::optional<Error> fault() const;
    /// The key that a peer with this identity must have. May be called from any thread.
    [[nodiscard]] HostTransport::KeyAnswer keyOf(const PskIdentity& identity) const;

    /// Whether there are changes that were not handed over.
    [[nodiscard]] bool isUnwritten() const { return m_isUnwritten; }
    /// Hands over all changes so far. @returns what writes them, on any thread
    [[nodiscard]] std::function<Result<void>()> handOver();
    /// What was handed over last is stored.
    void stored() { m_stored = m_handedOver; }
    /// Undoes all changes since the last that were stored, except where the secrets are kept. They
    /// are to be written again.
    void giveUp();
    /// Writes all changes so far, at once. @returns FileUnwritable.
    [[nodiscard]] Result<void> write();

    /// Keeps the secrets beside the new file of the store from now on.
    void moveBeside(const std::filesystem::path& store);

    /// Gives a role another code; who has not come in with the old one is out, and a handshake that
    /// began with its key is not completed (HostTransport).
    void changeCode(Role role);

    /// Whether the key of this role's code is still being derived.
    [[nodiscard]] bool isDeriving(Role role) const;

    /// Stores what a peer proved, as long as it is connected.
    void connected(PeerAddress peer, const Credential& who);
    void disconnected(PeerAddress peer);
    /// @returns NotPermitted for a peer that proved another role, another participant, or a token
    ///          that is void; UsedElsewhere for one that was displaced, or whose token was
    ///          replaced; NameTaken for one that proved a role by its code, where the participant
    ///          has a token: once there is one, nothing else proves a return. But a token that
    ///          nobody has come in with may not have arrived: until then the same run of the
    ///          program returns by its code.
    /// @param isSameRun whether the peer proved that it is the run that came in as the participant
    [[nodiscard]] Result<void> check(PeerAddress peer, Role role, ParticipantId participant,
                                     bool isSameRun = false) const;
    /// From now on this peer is that participant, and nobody else.
    void admitted(PeerAddress peer, ParticipantId participant);
    /// Whether the peer proved which participant it is: by a token that holds, or by coming in
    /// before.
    [[nodiscard]] bool isProven(PeerAddress peer) const;

    /// Another program proved the participant of this peer, too: this one proves nothing any more.
    void displace(PeerAddress peer);
    /// Replaces the token of a participant. @param keeper the peer that is the participant from now
    /// on: all others that proved so are out
    [[nodiscard]] AccessKey replaceToken(Role role, ParticipantId participant,
                                         std::optional<PeerAddress> keeper);
    /// A participant has no token any more, and no peer proves that it is this participant.
    void revokeToken(Role role, ParticipantId participant);

    /// The token with which an admitted participant can join again.
    /// @returns NotPermitted for a peer whose code was changed before it came in.
    [[nodiscard]] Result<AccessKey> issueToken(PeerAddress peer, ParticipantId participant);

private:
    HostAccess(SessionSecrets secrets, DeriveKey derive);
    void deriveMissing();
    void derive(Role role);

    /// What a peer proved.
    struct Proof {
        Credential who;
        std::optional<AccessKey> token; ///< that the participant had then; none for a code
    };
    /// Nothing where none was issued.
    [[nodiscard]] std::optional<AccessKey> tokenOf(const Credential& who) const;
    [[nodiscard]] AccessKey newToken(const Credential& who);
    /// Whether the participant is still proved: its token is the one of then.
    [[nodiscard]] bool holds(const Proof& proof) const
    {
        return proof.who.participant && proof.token == tokenOf(proof.who);
    }

    mutable std::mutex m_mutex; // over m_secrets: it changes on the node's thread
    SessionSecrets m_secrets;
    SessionSecrets m_handedOver;
    SessionSecrets m_stored;
    bool m_isUnwritten = false;
    std::map<PeerAddress, Proof> m_peers;
    std::set<PeerAddress> m_displaced;
    std::map<Role, Error> m_faults;    ///< why a role's code has no key
    std::set<ParticipantId> m_unshown; // whose token was issued, and nobody has come in with
    KeyDeriver m_deriver;
};

} // namespace carina
