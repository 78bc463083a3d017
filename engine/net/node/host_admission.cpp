#include "engine/net/entry/token_message.h"
#include "engine/net/node/host_driver.h"
#include "engine/session/facts/fact_codec.h"

#include <QRandomGenerator>

#include <algorithm>

// Who comes in, stays and goes; the rest of the driver is in host_driver.cpp.

namespace carina
{
namespace
{

constexpr ParticipantId kHostItself{0};

} // namespace

void HostDriver::connected(PeerAddress peer, const Credential& who, LocalTime)
{
    m_access->connected(peer, who);
}

void HostDriver::disconnected(PeerAddress peer, LocalTime now)
{
    m_access->disconnected(peer);
    m_core->drop(peer, now);
}

void HostDriver::refused(const Error& why, LocalTime) { m_refusal = why; }

void HostDriver::receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now)
{
    if (!isTokenRequest(bytes)) {
        m_speaker = from;
        m_core->receive(from, bytes, now);
        return;
    }
    const auto peer = m_core->peers().find(from);
    if (peer == m_core->peers().end())
        return;
    // Without a token the peer comes back by its code.
    if (const auto token = m_access->issueToken(from, peer->second.participant))
        m_tokens.push_back({from, encodeToken({peer->second.participant, *token})});
}

Result<ParticipantId> HostDriver::identify(const ProposalRecord& join, LocalTime now) const
{
    const auto proposal = fromRecord(join);
    if (!proposal)
        return tl::unexpected(proposal.error());
    const auto* joined = std::get_if<fact::ParticipantJoined>(&proposal->body);
    if (!joined || joined->participant.value != 0)
        return fail(Errc::NotPermitted);
    const Participant& self = m_authority.state().participants().at(kHostItself);
    if (joined->name == self.name && joined->role == self.role)
        return kHostItself;
    return m_authority.judge(*proposal, m_core->sessionTime(now), Duration{})
        .and_then([&](const Fact& fact) {
            const ParticipantId id = std::get<fact::ParticipantJoined>(fact.body).participant;
            return m_access->check(m_speaker, joined->role, id).map([id] { return id; });
        });
}

Result<Admission> HostDriver::admit(const ProposalRecord& join, LocalTime now)
{
    const auto participant = identify(join, now);
    auto proposal = fromRecord(join);
    if (!participant || !proposal)
        return tl::unexpected(participant ? proposal.error() : participant.error());
    const auto& participants = m_authority.state().participants();
    const auto known = participants.find(*participant);
    // The same run of a program that was given up meanwhile comes in a second time.
    if (m_authority.settled(proposal->id) && known != participants.end() && !known->second.present)
        proposal->id = ProposalId{QRandomGenerator::system()->generate64()};
    return decide(*proposal, now).map([&](const FactRecord& fact) {
        return Admission{*participant, fact};
    });
}

void HostDriver::left(ParticipantId participant, LocalTime now)
{
    // A store that fails is shown as the node's refusal; the participant is gone all the same.
    static_cast<void>(decideByHost(StationId{}, fact::ParticipantLeft{participant}, now));
}

void HostDriver::dropAbsent(LocalTime now)
{
    if (now < m_returnsEnd)
        return;
    m_returnsEnd = LocalTime::max();
    std::vector<ParticipantId> absent;
    for (const auto& [id, participant] : m_authority.state().participants()) {
        const bool isHere =
            id == kHostItself || std::ranges::any_of(m_core->peers(), [&](const auto& p) {
                return p.second.participant == id;
            });
        if (participant.present && !isHere)
            absent.push_back(id);
    }
    for (const ParticipantId id : absent)
        left(id, now);
}

} // namespace carina
