#include "engine/sync/actions/host_actions.h"

#include <utility>

namespace carina
{
namespace
{

constexpr ParticipantId kActingHost{0};

EventAck ackOf(const EventCpo& event) { return {event.object, event.epoch, event.action}; }

} // namespace

void HostActions::join(PeerAddress address, ParticipantId participant, LocalTime now)
{
    Peer& peer = m_peers[address] = Peer{participant};
    for (const EventCpo& event : m_actions.table().newest())
        peer.events.begin(event, now);
}

void HostActions::share(ObjectId object, const Ownership& ownership)
{
    if (!m_actions.share(object, ownership))
        return;
    m_own.forget(object);
    if (const EventCpo* last = m_actions.table().newest(object))
        restore(*last);
}

Result<void> HostActions::act(ObjectId object, const ObjectAction& action, SessionTime session,
                              LocalTime now)
{
    return m_actions.begun(object, action, session).map([&](const EventCpo& event) {
        m_own.begin(event, now);
        spread(kActingHost, event, session, now);
    });
}

void HostActions::take(PeerAddress from, const EventCpo& event, SessionTime session, LocalTime now)
{
    const auto peer = m_peers.find(from);
    if (peer == m_peers.end() || !m_actions.isOwners(peer->second.participant, event))
        return;
    if (spread(peer->second.participant, event, session, now) != EventTable::Verdict::Refused)
        peer->second.acks.emplace_back(ackOf(event));
}

void HostActions::take(PeerAddress from, const EventBeat& beat, SessionTime session, LocalTime now)
{
    if (const EventCpo* event = m_actions.table().named(beat))
        take(from, EventCpo{*event}, session, now);
}

void HostActions::acknowledge(PeerAddress from, const EventAck& ack)
{
    if (const auto peer = m_peers.find(from); peer != m_peers.end())
        peer->second.events.acknowledge(ack);
}

void HostActions::restore(const EventCpo& event)
{
    if (const auto continued = m_actions.continued(event))
        m_handedOver.push_back(*continued);
}

std::vector<EventCpo> HostActions::takeChanged()
{
    std::vector<EventCpo> events;
    for (const ObjectId object : std::exchange(m_changed, {}))
        events.push_back(*m_actions.table().newest(object));
    return events;
}

EventTable::Verdict HostActions::spread(ParticipantId from, const EventCpo& event,
                                        SessionTime session, LocalTime now)
{
    const auto verdict = m_actions.take(event, session, now);
    if (verdict == EventTable::Verdict::New)
        m_changed.insert(event.object);
    LocalTime turn = now;
    for (auto& [address, peer] : m_peers) {
        if (peer.participant == from)
            continue;
        if (verdict == EventTable::Verdict::New)
            peer.events.begin(event, now);
        else if (verdict == EventTable::Verdict::Known)
            peer.events.beat(event, turn);
        turn += EventRepeater::kTurn;
    }
    return verdict;
}

void HostActions::advance(SessionTime session, LocalTime now)
{
    for (const EventCpo& event : std::exchange(m_handedOver, {}))
        if (spread(kActingHost, event, session, now) == EventTable::Verdict::New
            && m_actions.isOwn(event.object))
            m_own.begin(event, now);
    for (const DueEvent& due : m_own.takeDue(now)) {
        m_own.acknowledge(ackOf(due.event));
        spread(kActingHost, due.event, session, now);
    }
}

std::vector<WireRecord> HostActions::takeDue(PeerAddress to, LocalTime now)
{
    const auto peer = m_peers.find(to);
    if (peer == m_peers.end())
        return {};
    std::vector<WireRecord> records = std::exchange(peer->second.acks, {});
    for (const DueEvent& due : peer->second.events.takeDue(now))
        records.push_back(due.record());
    return records;
}

LocalTime HostActions::nextDue() const
{
    if (!m_handedOver.empty())
        return LocalTime::min();
    LocalTime next = m_own.nextDue();
    for (const auto& [address, peer] : m_peers)
        next = std::min(next, peer.acks.empty() ? peer.events.nextDue() : LocalTime::min());
    return next;
}

} // namespace carina
