#include "engine/net/node/host_access.h"

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
    : m_secrets{std::move(secrets)},
      m_handedOver{m_secrets},
      m_stored{m_secrets},
      m_deriver{std::move(derive)}
{
}

std::function<Result<void>()> HostAccess::handOver()
{
    m_isUnwritten = false;
    m_handedOver = m_secrets;
    return [secrets = m_secrets] { return secrets.write(); };
}

void HostAccess::giveUp()
{
    const JoinCodes given = m_secrets.codes();
    {
        const std::scoped_lock lock{m_mutex};
        m_secrets.revertTo(m_stored);
    }
    // A number that was undone is the next newcomer's.
    for (auto& [peer, who] : m_peers)
        if (who.participant && !m_secrets.token(who.role, *who.participant))
            who.participant.reset();
    m_handedOver = m_stored;
    m_isUnwritten = true;
    for (const auto& [role, code] : given)
        if (m_secrets.codes().at(role) != code && !m_secrets.codeKey(role))
            derive(role);
}

Result<void> HostAccess::write()
{
    return handOver()().map([this] { stored(); });
}

void HostAccess::deriveMissing()
{
    // In the order in which people come.
    for (const Role role : {Role::Trainee, Role::Observer, Role::Instructor}) {
        if (!m_secrets.codeKey(role))
            derive(role);
    }
}

void HostAccess::derive(Role role)
{
    const JoinCode code = m_secrets.codes().at(role);
    m_faults.erase(role);
    m_deriver.derive(code, sessionKey(sessionId()), [this, role, code](const auto& key) {
        const std::scoped_lock lock{m_mutex};
        if (m_secrets.codes().at(role) != code)
            return; // it was changed meanwhile
        if (key) {
            m_secrets.setCodeKey(role, *key);
            m_faults.erase(role);
        } else {
            m_faults.insert_or_assign(role, key.error());
        }
        m_isUnwritten = true;
    });
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

void HostAccess::moveBeside(const std::filesystem::path& store)
{
    const std::scoped_lock lock{m_mutex};
    m_secrets.moveBeside(store);
    m_isUnwritten = true;
}

void HostAccess::changeCode(Role role)
{
    {
        const std::scoped_lock lock{m_mutex};
        m_secrets.changeCode(role);
        m_isUnwritten = true;
    }
    std::erase_if(m_peers, [role](const auto& peer) {
        return peer.second.role == role && !peer.second.participant;
    });
    derive(role);
}

std::optional<Error> HostAccess::fault() const
{
    return m_faults.empty() ? std::nullopt : std::optional{m_faults.begin()->second};
}

bool HostAccess::isDeriving(Role role) const
{
    const std::scoped_lock lock{m_mutex};
    return !m_secrets.codeKey(role) && !m_faults.contains(role);
}

void HostAccess::connected(PeerAddress peer, const Credential& who)
{
    m_peers.insert_or_assign(peer, who);
    if (who.participant)
        m_unshown.erase(*who.participant);
}

void HostAccess::disconnected(PeerAddress peer)
{
    m_peers.erase(peer);
    m_displaced.erase(peer);
}

Result<void> HostAccess::check(PeerAddress peer, Role role, ParticipantId participant,
                               bool isSameRun) const
{
    if (m_displaced.contains(peer))
        return fail(Errc::UsedElsewhere);
    const auto known = m_peers.find(peer);
    if (known == m_peers.end() || known->second.role != role)
        return fail(Errc::NotPermitted, "the code is one for another role");
    if (known->second.participant && *known->second.participant != participant)
        return fail(Errc::NotPermitted, "the token is somebody else's");
    if (isSameRun && m_unshown.contains(participant))
        return {};
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

void HostAccess::displace(PeerAddress peer)
{
    if (m_peers.contains(peer)) // else it is gone
        m_displaced.insert(peer);
}

AccessKey HostAccess::replaceToken(Role role, ParticipantId participant)
{
    m_unshown.erase(participant);
    const std::scoped_lock lock{m_mutex};
    m_isUnwritten = true;
    return m_secrets.newToken(role, participant);
}

void HostAccess::revokeToken(Role role, ParticipantId participant)
{
    m_unshown.erase(participant);
    const std::scoped_lock lock{m_mutex};
    if (!m_secrets.token(role, participant))
        return;
    m_secrets.revokeToken(role, participant);
    m_isUnwritten = true;
}

Result<AccessKey> HostAccess::issueToken(PeerAddress peer, ParticipantId participant)
{
    const auto known = m_peers.find(peer);
    if (known == m_peers.end())
        return fail(Errc::NotPermitted, "its code was changed before it came in");
    const Role role = known->second.role;
    if (const auto issued = m_secrets.token(role, participant))
        return *issued;
    const AccessKey token = replaceToken(role, participant);
    m_unshown.insert(participant);
    return token;
}

} // namespace carina
