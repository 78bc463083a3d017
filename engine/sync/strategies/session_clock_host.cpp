#include "engine/sync/strategies/session_clock_host.h"

#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>

namespace carina
{

std::unique_ptr<StarNode> SessionClockHost::make(std::uint16_t participants, LocalTime now)
{
    return std::make_unique<SessionClockHost>(participants, now);
}

SessionClockHost::SessionClockHost(std::uint16_t participants, LocalTime now)
{
    for (std::uint16_t id = 1; id <= participants; ++id)
        m_peers.emplace(ParticipantId{id}, Peer{PeerLink{id, Duration{}, now}});
}

void SessionClockHost::receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now)
{
    const auto peer = m_peers.find(from);
    const auto datagram = decodeDatagram(bytes);
    if (peer == m_peers.end() || !datagram || datagram->header.sender != from)
        return;
    peer->second.link.heard(datagram->header, now);
    peer->second.answer = peer->second.answer || datagram->header.answerNow;
    for (const WireRecord& record : datagram->records) {
        if (const auto* event = std::get_if<EventCpo>(&record))
            take(from, *event, now);
        else if (const auto* beat = std::get_if<EventBeat>(&record)) {
            if (const EventCpo* known = m_table.named(*beat))
                take(from, EventCpo{*known}, now);
        } else if (const auto* ack = std::get_if<EventAck>(&record))
            peer->second.events.acknowledge(*ack);
    }
}

void SessionClockHost::take(ParticipantId from, const EventCpo& event, LocalTime now)
{
    const auto verdict = m_table.take(event, SessionTime{now.time_since_epoch()}, now);
    if (verdict == EventTable::Verdict::Refused)
        return;
    LocalTime turn = now;
    for (auto& [id, peer] : m_peers) {
        if (id == from) {
            peer.acks.emplace_back(EventAck{event.object, event.epoch, event.action});
            continue;
        }
        if (verdict == EventTable::Verdict::New)
            peer.events.begin(event, now);
        else if (verdict == EventTable::Verdict::Known)
            peer.events.beat(event, turn);
        turn += EventRepeater::kTurn;
    }
}

void SessionClockHost::readExternal(const ExternalTime& reading, LocalTime)
{
    for (auto& [id, peer] : m_peers)
        peer.acks.emplace_back(ExternalTimeRecord{reading});
}

void SessionClockHost::advance(LocalTime now)
{
    for (auto& [id, peer] : m_peers) {
        std::vector<WireRecord> records = std::exchange(peer.acks, {});
        for (const DueEvent& due : peer.events.takeDue(now))
            records.push_back(due.record());
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

LocalTime SessionClockHost::nextWake() const
{
    LocalTime next = LocalTime::max();
    for (const auto& [id, peer] : m_peers)
        next = std::min(next, peer.events.nextDue());
    return next;
}

} // namespace carina
