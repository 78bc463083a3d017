#include "engine/sync/strategies/session_clock_host.h"

#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

SessionTime sessionTimeAt(LocalTime now) { return SessionTime{now.time_since_epoch()}; }

} // namespace

std::unique_ptr<StarNode> SessionClockHost::make(const std::vector<ParticipantId>& participants,
                                                 LocalTime now)
{
    return std::make_unique<SessionClockHost>(participants, false, now);
}

std::unique_ptr<StarNode>
SessionClockHost::makeWithLag(const std::vector<ParticipantId>& participants, LocalTime now)
{
    return std::make_unique<SessionClockHost>(participants, true, now);
}

SessionClockHost::SessionClockHost(const std::vector<ParticipantId>& participants, bool hasLag,
                                   LocalTime now)
{
    if (hasLag)
        m_actions.setStrategy({.kind = StrategyKind::LocalLag}, now);
    for (const ParticipantId id : participants) {
        m_peers.emplace(id, Peer{PeerLink{id.value, Duration{}, now}});
        m_actions.join(id.value, id, now);
    }
}

void SessionClockHost::receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now)
{
    const auto peer = m_peers.find(from);
    const auto datagram = decodeDatagram(bytes);
    if (peer == m_peers.end() || !datagram || datagram->header.sender != from)
        return;
    peer->second.link.heard(datagram->header, now);
    peer->second.answer = peer->second.answer || datagram->header.answerNow;
    if (const auto longest = peer->second.link.longestRoundTrip())
        m_actions.measured(from.value, *longest / 2);
    for (const WireRecord& record : datagram->records) {
        if (const auto* event = std::get_if<EventCpo>(&record))
            take(from, *event, now);
        else if (const auto* beat = std::get_if<EventBeat>(&record))
            m_actions.take(from.value, *beat, sessionTimeAt(now), now);
        else if (const auto* ack = std::get_if<EventAck>(&record))
            m_actions.acknowledge(from.value, *ack);
    }
}

void SessionClockHost::take(ParticipantId from, const EventCpo& event, LocalTime now)
{
    if (m_owners.try_emplace(event.object, from).second)
        m_actions.share(event.object, {from, event.epoch});
    m_actions.take(from.value, event, sessionTimeAt(now), now);
}

void SessionClockHost::readExternal(const ExternalTime& reading, LocalTime)
{
    for (auto& [id, peer] : m_peers)
        peer.outbox.emplace_back(ExternalTimeRecord{reading});
}

void SessionClockHost::advance(LocalTime now)
{
    m_actions.advance(sessionTimeAt(now), now);
    for (auto& [id, peer] : m_peers) {
        std::vector<WireRecord> records = m_actions.takeDue(id.value, now);
        std::ranges::move(std::exchange(peer.outbox, {}), std::back_inserter(records));
        if (records.empty() && !peer.answer)
            continue;
        peer.answer = false;
        const auto nextHeader = [&, to = &peer] {
            BundleHeader header = to->link.nextHeader(now);
            header.fromHost = true;
            header.sender = kStarHost;
            return header;
        };
        for (auto& bytes : packDatagrams(records, nextHeader))
            send(id, std::move(bytes));
    }
}

} // namespace carina
