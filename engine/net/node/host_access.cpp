#include "engine/net/node/host_access.h"

#include "engine/net/entry/session_identity.h"

#include <vector>

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
    std::vector<Proof*> held;
    for (auto& [peer, proof] : m_peers)
        if (holds(proof))
            held.push_back(&proof);
    {
        const std::scoped_lock lock{m_mutex};
        m_secrets.revertTo(m_stored);
    }
    for (Proof* proof : held)
        proof->token = tokenOf(proof->who);
    // A number that was undone is the next newcomer's.
    for (auto& [peer, proof] : m_peers)
        if (proof.who.participant && !tokenOf(proof.who))
            proof.who.participant.reset();
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
        const Credential& who = peer.second.who;
        return who.role == role && !who.participant;
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

std::optional<AccessKey> HostAccess::tokenOf(const Credential& who) const
{
    return who.participant ? m_secrets.token(who.role, *who.participant) : std::nullopt;
}

void HostAccess::connected(PeerAddress peer, const Credential& who)
{
    m_peers.insert_or_assign(peer, Proof{who, tokenOf(who)});
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
    if (known == m_peers.end() || known->second.who.role != role)
        return fail(Errc::NotPermitted, "the code is one for another role");
    const auto& proved = known->second.who.participant;
    if (proved && *proved != participant)
        return fail(Errc::NotPermitted, "the token is somebody else's");
    if (proved && !holds(known->second))
        return fail(Errc::NotPermitted, "the token is void");
    if (isSameRun && m_unshown.contains(participant))
        return {};
    if (!proved && tokenOf({role, participant}))
        return fail(Errc::NameTaken, "only its token proves who it is");
    return {};
}

void HostAccess::admitted(PeerAddress peer, ParticipantId participant)
{
    const auto known = m_peers.find(peer);
    if (known == m_peers.end())
        return;
    known->second.who.participant = participant;
    known->second.token = tokenOf(known->second.who);
}

bool HostAccess::isProven(PeerAddress peer) const
{
    const auto known = m_peers.find(peer);
    return known != m_peers.end() && holds(known->second);
}

void HostAccess::displace(PeerAddress peer)
{
    if (m_peers.contains(peer)) // else it is gone
        m_displaced.insert(peer);
}

AccessKey HostAccess::replaceToken(Role role, ParticipantId participant,
                                   std::optional<PeerAddress> keeper)
{
    m_unshown.erase(participant);
    const Credential who{role, participant};
    for (const auto& [peer, proof] : m_peers)
        if (proof.who == who && peer != keeper)
            m_displaced.insert(peer);
    const AccessKey token = newToken(who);
    if (const auto known = keeper ? m_peers.find(*keeper) : m_peers.end(); known != m_peers.end())
        known->second.token = token;
    return token;
}

AccessKey HostAccess::newToken(const Credential& who)
{
    const std::scoped_lock lock{m_mutex};
    m_isUnwritten = true;
    return m_secrets.newToken(who.role, *who.participant);
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
    const Credential who{known->second.who.role, participant};
    if (const auto issued = tokenOf(who))
        return *issued;
    const AccessKey token = newToken(who);
    // Those of the same run that came in before it had one.
    for (auto& [other, proof] : m_peers)
        if (proof.who == who)
            proof.token = token;
    m_unshown.insert(participant);
    return token;
}

} // namespace carina
