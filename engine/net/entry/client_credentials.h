#pragma once

#include "engine/net/entry/key_deriver.h"
#include "engine/net/entry/token_folder.h"
#include "engine/net/secure/dtls.h"

namespace carina
{

/// What a client may prove itself with: the token of the session it was in before, else the key of
/// the code that its person typed, derived once for each session. Lives on the node's thread.
class ClientCredentials
{
public:
    /// So often must a host turn an offer down before it is believed: the first may be a stranger's
    /// word.
    static constexpr int kRejectionsBelieved = 3;

    ClientCredentials(Role role, std::optional<JoinCode> code, TokenFolder tokens,
                      DeriveKey derive);

    /// For this session. Nothing while the key is being derived, or when refused.
    /// @param hint what the host calls itself; anything but a session id gets no offer
    [[nodiscard]] std::optional<KeyOffer> offerFor(const std::string& hint);
    /// For the session that took the last offer, likewise.
    [[nodiscard]] std::optional<KeyOffer> offerAgain();
    /// The host does not take this offer.
    void rejected(const KeyOffer& offer);
    /// The host cannot be come to, or not be trusted; believed as often as it is said of an offer.
    void turnedAway(const Error& why);
    /// The host took this offer.
    void accepted(const KeyOffer& offer);
    /// A token for the session that took the last offer.
    void keepToken(const TokenFolder::Token& token);
    /// The session that took the last offer has a token for us.
    [[nodiscard]] bool hasToken() const;

    /// There may be an offer now.
    [[nodiscard]] bool mayTry() const { return !m_deriving && !m_refusal; }
    /// Why there will be none any more.
    [[nodiscard]] const std::optional<Error>& refusal() const { return m_refusal; }
    /// Called when mayTry() or refusal() changed by itself.
    void onChange(std::function<void()> callback) { m_onChange = std::move(callback); }

private:
    struct CodeKey {
        std::string sessionId;
        AccessKey key;
    };
    void derive(const std::string& sessionId);
    void derived(const std::string& sessionId, const Result<AccessKey>& key);

    Role m_role;
    std::optional<JoinCode> m_code;
    TokenFolder m_tokens;
    std::string m_tokenTurnedDown; // the session that does not take our token
    std::optional<CodeKey> m_codeKey;
    bool m_deriving = false;
    std::optional<Error> m_refusal;
    int m_rejections = 0;
    std::string m_session; // that took the last offer
    std::function<void()> m_onChange;
    KeyDeriver m_deriver;
};

} // namespace carina
