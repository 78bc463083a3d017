#include "engine/net/node/host_access.h"

#include "engine/core/expects.h"
#include "engine/net/entry/session_identity.h"

namespace carina
{

Result<std::unique_ptr<HostAccess>> HostAccess::open(const std::filesystem::path& secrets,
                                                     const std::string& sessionId, DeriveKey derive)
{
    auto known = SessionSecrets::open(secrets, sessionId);
    if (!known)
        return tl::unexpected(known.error());
    std::unique_ptr<HostAccess> access{new HostAccess{*std::move(known), std::move(derive)}};
    access->deriveMissing();
    return access;
}

HostAccess::HostAccess(SessionSecrets secrets, DeriveKey derive)
    : m_secrets{std::move(secrets)}, m_deriver{std::move(derive)}
{
}

void HostAccess::deriveMissing()
{
    // In the order in which people come.
    for (const Role role : {Role::Trainee, Role::Observer, Role::Instructor}) {
        if (m_secrets.codeKey(role))
            continue;
        m_deriver.derive(m_secrets.codes().at(role), sessionKey(sessionId()),
                         [this, role](const Result<AccessKey>& key) {
                             const std::scoped_lock lock{m_mutex};
                             const auto kept =
                                 key ? m_secrets.setCodeKey(role, *key) : key.map([](auto&) {});
                             if (!kept)
                                 m_fault = kept.error();
                         });
    }
}

HostTransport::KeyAnswer HostAccess::keyOf(const PskIdentity& identity) const
{
    using State = HostTransport::KeyAnswer::State;
    if (identity.sessionId != sessionId())
        return {};
    const Credential& who = identity.who;
    const std::scoped_lock lock{m_mutex};
    const auto key =
        who.participant ? m_secrets.token(who.role, *who.participant) : m_secrets.codeKey(who.role);
    if (key)
        return {State::Known, *key};
    return {who.participant ? State::Unknown : State::NotYet, {}};
}

Result<void> HostAccess::moveBeside(const std::filesystem::path& store)
{
    const std::scoped_lock lock{m_mutex};
    return m_secrets.moveBeside(store);
}

void HostAccess::connected(PeerAddress peer, const Credential& who)
{
    m_peers.insert_or_assign(peer, who);
}

void HostAccess::disconnected(PeerAddress peer) { m_peers.erase(peer); }

Result<void> HostAccess::check(PeerAddress peer, Role role, ParticipantId participant) const
{
    const auto known = m_peers.find(peer);
    if (known == m_peers.end() || known->second.role != role)
        return fail(Errc::NotPermitted, "the code is one for another role");
    if (known->second.participant && *known->second.participant != participant)
        return fail(Errc::NotPermitted, "the token is somebody else's");
    const std::scoped_lock lock{m_mutex};
    if (!known->second.participant && m_secrets.token(role, participant))
        return fail(Errc::NameTaken, "only its token proves who it is");
    return {};
}

void HostAccess::admitted(PeerAddress peer, ParticipantId participant)
{
    if (const auto known = m_peers.find(peer); known != m_peers.end())
        known->second.participant = participant;
}

bool HostAccess::isProven(PeerAddress peer) const
{
    const auto known = m_peers.find(peer);
    return known != m_peers.end() && known->second.participant.has_value();
}

Result<AccessKey> HostAccess::issueToken(PeerAddress peer, ParticipantId participant)
{
    const auto known = m_peers.find(peer);
    CARINA_EXPECTS(known != m_peers.end());
    const std::scoped_lock lock{m_mutex};
    return m_secrets.issueToken(known->second.role, participant);
}

} // namespace carina
