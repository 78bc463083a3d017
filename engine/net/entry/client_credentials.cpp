#include "engine/net/entry/client_credentials.h"

#include "engine/net/entry/session_identity.h"

namespace carina
{

ClientCredentials::ClientCredentials(Role role, std::optional<JoinCode> code, TokenFolder tokens,
                                     DeriveKey derive)
    : m_role{role},
      m_code{std::move(code)},
      m_tokens{std::move(tokens)},
      m_deriver{std::move(derive)}
{
}

void ClientCredentials::setPlace(const std::string& address, std::uint16_t port)
{
    m_visit = {{}, address, port};
    const auto last = m_tokens.lastVisit();
    if (last && last->address == address && last->port == port)
        m_before = last->sessionId;
}

/// Which session a program that is started again is to look for. Where that cannot be written, it
/// waits at the place that it is given.
void ClientCredentials::keepVisit()
{
    if (m_visit.address.empty() || m_visit.sessionId == m_session)
        return;
    m_visit.sessionId = m_session;
    static_cast<void>(m_tokens.keepVisit(m_visit));
}

std::string ClientCredentials::sought() const
{
    const std::string& session = m_session.empty() ? m_before : m_session;
    const bool hasOne =
        !session.empty() && session != m_tokenTurnedDown && m_tokens.find(session).has_value();
    return hasOne ? session : std::string{};
}

std::optional<KeyOffer> ClientCredentials::offerFor(const std::string& hint)
{
    if (!isSessionId(hint) || !mayTry() || (!m_session.empty() && hint != m_session))
        return std::nullopt;
    if (const auto token = m_tokens.find(hint); token && hint != m_tokenTurnedDown)
        return KeyOffer{{{m_role, token->participant}, hint}, token->key};
    if (!m_code) {
        m_refusal = Error{Errc::WrongCode, "no code was given"};
        return std::nullopt;
    }
    if (m_codeKey && m_codeKey->sessionId == hint)
        return KeyOffer{{{m_role, std::nullopt}, hint}, m_codeKey->key};
    derive(hint);
    return std::nullopt;
}

std::optional<KeyOffer> ClientCredentials::offerAgain() { return offerFor(m_session); }

std::optional<KeyOffer> ClientCredentials::offerToFound(const std::string& hint) const
{
    if (hint.empty() || hint != sought() || !mayTry())
        return std::nullopt;
    const auto token = m_tokens.find(hint);
    return KeyOffer{{{m_role, token->participant}, hint}, token->key};
}

void ClientCredentials::rejected(const KeyOffer& offer)
{
    if (++m_rejections < kRejectionsBelieved)
        return;
    m_rejections = 0;
    if (offer.identity.who.participant)
        m_tokenTurnedDown = offer.identity.sessionId;
    else
        m_refusal = Error{Errc::WrongCode, m_code ? m_code->text() : std::string{}};
}

void ClientCredentials::turnedAway(const Error& why)
{
    if (++m_rejections < kRejectionsBelieved)
        return;
    m_rejections = 0;
    m_refusal = why;
}

void ClientCredentials::accepted(const KeyOffer& offer)
{
    m_rejections = 0;
    m_session = offer.identity.sessionId;
    if (offer.identity.who.participant)
        keepVisit();
}

void ClientCredentials::keepToken(const TokenFolder::Token& token)
{
    // One that cannot be written is known until this program ends.
    static_cast<void>(m_tokens.keep(m_session, token));
    m_tokenTurnedDown.clear();
    keepVisit();
}

bool ClientCredentials::hasToken() const
{
    return m_session != m_tokenTurnedDown && m_tokens.find(m_session).has_value();
}

void ClientCredentials::derive(const std::string& sessionId)
{
    m_deriving = true;
    m_deriver.derive(*m_code, sessionKey(sessionId),
                     [this, sessionId](const auto& key) { derived(sessionId, key); });
}

void ClientCredentials::derived(const std::string& sessionId, const Result<AccessKey>& key)
{
    m_deriving = false;
    if (key)
        m_codeKey = CodeKey{sessionId, *key};
    else
        m_refusal = key.error();
    if (m_onChange)
        m_onChange();
}

} // namespace carina
