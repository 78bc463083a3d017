#pragma once

#include "engine/net/entry/key_deriver.h"
#include "engine/net/entry/token_folder.h"
#include "engine/net/secure/dtls.h"

namespace carina
{

/// The keys that a client can authenticate with: the token of an earlier admission to the session,
/// else the key of the typed code, derived once for each session. Used on the node's thread.
class ClientCredentials
{
public:
    /// Rejections of an offer after which it is given up: a single one may be forged, as it is not
    /// authenticated.
    static constexpr int kRejectionsBelieved = 3;

    ClientCredentials(Role role, std::optional<JoinCode> code, TokenFolder tokens,
                      DeriveKey derive);

    /// Says which place was given for the host. Once in a session, that is kept with the tokens;
    /// and where a program of this role and name was in one when the same place was given last,
    /// that session is sought().
    void setPlace(const std::string& address, std::uint16_t port);

    /// The key to offer to a session. Nothing while the key is being derived, or after a refusal;
    /// nor to another session than the one that this program is in: it may have taken the address
    /// of that one, which comes back at another.
    /// @param hint PSK identity hint of the host; nothing is offered unless it is a session id
    [[nodiscard]] std::optional<KeyOffer> offerFor(const std::string& hint);
    /// As offerFor, for the session that accepted the last offer.
    [[nodiscard]] std::optional<KeyOffer> offerAgain();
    /// The token for the session that is sought, to be offered to a host that was found and that
    /// nobody vouches for: an impostor learns nothing from a handshake with 256 random bits, as it
    /// could from one with a code. Nothing for another hint.
    [[nodiscard]] std::optional<KeyOffer> offerToFound(const std::string& hint) const;
    /// The host rejected this offer.
    void rejected(const KeyOffer& offer);
    /// The host cannot be joined or trusted; given up after kRejectionsBelieved, as for an offer.
    void turnedAway(const Error& why);
    /// No offer is made any more.
    void giveUp(const Error& why) { m_refusal = why; }
    /// The host accepted this offer.
    void accepted(const KeyOffer& offer);
    /// Stores a token for the session that accepted the last offer.
    void keepToken(const TokenFolder::Token& token);
    /// Whether there is a token for the session that accepted the last offer.
    [[nodiscard]] bool hasToken() const;
    /// The session that accepted the last offer; empty before.
    [[nodiscard]] const std::string& session() const { return m_session; }
    /// The session whose host is to be searched for, where it does not answer: that one, or,
    /// before, the one of setPlace(); empty where there is none, or no token of it that may be
    /// offered.
    [[nodiscard]] std::string sought() const;

    /// Whether offerFor can return an offer: no key is being derived, and nothing was refused.
    [[nodiscard]] bool mayTry() const { return !m_deriving && !m_refusal; }
    /// Why no further offer is made.
    [[nodiscard]] const std::optional<Error>& refusal() const { return m_refusal; }
    /// Sets a callback for changes of mayTry() or refusal() after a key derivation.
    void onChange(std::function<void()> callback) { m_onChange = std::move(callback); }

private:
    struct CodeKey {
        std::string sessionId;
        AccessKey key;
    };
    void keepVisit();
    void derive(const std::string& sessionId);
    void derived(const std::string& sessionId, const Result<AccessKey>& key);

    Role m_role;
    std::optional<JoinCode> m_code;
    TokenFolder m_tokens;
    std::string m_tokenTurnedDown; // the session that rejected the token
    std::optional<CodeKey> m_codeKey;
    bool m_deriving = false;
    std::optional<Error> m_refusal;
    int m_rejections = 0;
    std::string m_session;      // that accepted the last offer
    std::string m_before;       // that the last program was in
    TokenFolder::Visit m_visit; // with the place that was given
    std::function<void()> m_onChange;
    KeyDeriver m_deriver;
};

} // namespace carina
