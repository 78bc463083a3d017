#include "engine/sync/actions/host_actions.h"

#include "engine/sync/strategies/relayed_message.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr ParticipantId kActingHost{0};

/// The same for all that is put off, so that it goes in one datagram.
LocalTime endOfInterval(LocalTime now)
{
    return LocalTime{(now.time_since_epoch() / HostActions::kTogether + 1)
                     * HostActions::kTogether};
}

EventAck ackOf(const EventCpo& event) { return {event.object, event.epoch, event.action}; }

} // namespace

void HostActions::setStrategy(const StrategyChoice& choice, LocalTime now,
                              std::optional<SessionTime> session)
{
    m_choice = choice;
    for (auto& [address, peer] : m_peers)
        peer.relayed.clear(); // of the strategy before
    m_strategy.choose(choice, now);
    m_actions.show(m_strategy.view());
    if (session)
        goOn(*session, now);
}

void HostActions::goOn(SessionTime session, LocalTime now)
{
    for (const EventCpo& event : m_actions.table().newest())
        if (m_actions.isOwners(kActingHost, event))
            m_strategy.begin(begunFrom(evaluate(event, session), session, event), now);
    m_actions.show(m_strategy.view());
}

void HostActions::measured(PeerAddress peer, Duration oneWay)
{
    if (const auto found = m_peers.find(peer); found != m_peers.end())
        found->second.delay = oneWay;
}

Duration HostActions::lagOf(const Peer* author) const
{
    Duration farthest{};
    for (const auto& [address, peer] : m_peers)
        if (&peer != author)
            farthest = std::max(farthest, peer.delay);
    return std::min((author ? author->delay : Duration{}) + farthest + m_longestWait + kLagMargin,
                    kLongestLocalLag);
}

void HostActions::join(PeerAddress address, ParticipantId participant, LocalTime now)
{
    Peer& peer = m_peers[address] = Peer{participant};
    for (const EventCpo& event : m_actions.table().newest())
        peer.events.begin(event, now);
    tellParticipants(now);
}

void HostActions::leave(PeerAddress address, LocalTime now)
{
    m_peers.erase(address);
    tellParticipants(now);
}

void HostActions::tellParticipants(LocalTime now)
{
    std::vector<ParticipantId> participants{kActingHost};
    for (const auto& [address, peer] : m_peers)
        participants.push_back(peer.participant);
    m_strategy.setParticipants(std::move(participants), now);
}

void HostActions::share(ObjectId object, const Ownership& ownership)
{
    if (!m_actions.share(object, ownership))
        return;
    m_own.forget(object);
    m_strategy.forget(object);
    for (auto& [address, peer] : m_peers)
        peer.relayed.erase(object); // of the owner before
    m_actions.show(m_strategy.view());
    if (const EventCpo* last = m_actions.table().newest(object)) {
        restore(*last);
        return;
    }
    // Nothing was done with it, or it was put back: what is void is neither sent nor stored.
    m_changed.erase(object);
    for (auto& [address, peer] : m_peers)
        peer.events.forget(object);
}

Result<void> HostActions::act(ObjectId object, const ObjectAction& action, SessionTime session,
                              LocalTime now)
{
    const SessionTime start = session + std::min(longestLagOf(m_choice), lagOf(nullptr));
    return m_actions.begun(object, action, start, now).map([&](const EventCpo& event) {
        m_own.begin(event, now);
        spread(kActingHost, event, session, now, now);
        m_strategy.begin(event, now);
        m_actions.show(m_strategy.view());
    });
}

void HostActions::take(PeerAddress from, const RelayedMessage& relayed,
                       const StrategyMessage& message, bool mayAct, LocalTime now)
{
    const auto peer = m_peers.find(from);
    if (peer == m_peers.end() || message.strategy != m_choice.kind)
        return;
    const auto isWithin = [&](std::map<ParticipantId, TokenBucket>& pairs) {
        return m_strategy.isPresent(relayed.to) && pairs[relayed.to].take(1.0, kFastestProbes, now);
    };
    const auto* action = std::get_if<EventCpo>(&relayed.content);
    const bool isAnswer = std::holds_alternative<DelayAnswer>(relayed.content);
    const bool isAllowed = action ? mayAct && m_actions.isOwners(peer->second.participant, *action)
                                  : isWithin(isAnswer ? peer->second.answers : peer->second.probes);
    if (!isAllowed)
        return;
    if (action)
        relay(peer->second, action->object, message.bytes, now);
    else
        m_strategy.receive(peer->second.participant, message.bytes, now);
}

bool HostActions::isRelayedAtOnce(Peer& peer, ObjectId object, LocalTime now)
{
    if (now == peer.relayedAt && peer.relayedThen.insert(object).second)
        return true; // goes out in the same datagrams
    if (!peer.relayedAtOnce.take(1.0, kAtOnce, now))
        return false;
    peer.relayedAt = now;
    peer.relayedThen = {object};
    return true;
}

void HostActions::relay(Peer& peer, ObjectId object, const std::vector<std::byte>& message,
                        LocalTime now)
{
    const auto waiting = peer.relayed.find(object);
    if (waiting != peer.relayed.end()) {
        waiting->second = message;
    } else if (isRelayedAtOnce(peer, object, now)) {
        m_strategy.receive(peer.participant, message, now);
    } else {
        peer.relayed.emplace(object, message);
        peer.relayedDue = std::min(peer.relayedDue, endOfInterval(now));
    }
}

void HostActions::relayDue(LocalTime now)
{
    for (auto& [address, peer] : m_peers) {
        if (now < peer.relayedDue)
            continue;
        peer.relayedDue = LocalTime::max();
        for (const auto& [object, message] : std::exchange(peer.relayed, {}))
            m_strategy.receive(peer.participant, message, now);
    }
}

void HostActions::take(PeerAddress from, const EventCpo& event, SessionTime session, LocalTime now)
{
    const auto peer = m_peers.find(from);
    if (peer == m_peers.end() || !m_actions.isOwners(peer->second.participant, event))
        return;
    const bool isKnown = m_actions.table().named({event.object, event.epoch, event.action});
    const bool isAtOnce = isKnown || peer->second.atOnce.take(1.0, kAtOnce, now);
    const LocalTime due = isAtOnce ? now : endOfInterval(now);
    if (spread(peer->second.participant, event, session, now, due) != EventTable::Verdict::Refused)
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
                                        SessionTime session, LocalTime now, LocalTime due)
{
    const auto verdict = m_actions.take(event, session, now);
    if (verdict == EventTable::Verdict::New)
        m_changed.insert(event.object);
    LocalTime turn = now;
    for (auto& [address, peer] : m_peers) {
        if (peer.participant == from)
            continue;
        if (verdict == EventTable::Verdict::New)
            peer.events.begin(event, due);
        else if (verdict == EventTable::Verdict::Known)
            peer.events.beat(event, turn);
        turn += EventRepeater::kTurn;
    }
    return verdict;
}

void HostActions::advance(SessionTime session, LocalTime now)
{
    relayDue(now);
    m_strategy.advance(now);
    m_actions.show(m_strategy.view());
    for (const EventCpo& event : std::exchange(m_handedOver, {}))
        if (spread(kActingHost, event, session, now, now) == EventTable::Verdict::New
            && m_actions.isOwn(event.object))
            m_own.begin(event, now);
    for (const DueEvent& due : m_own.takeDue(now)) {
        m_own.acknowledge(ackOf(due.event));
        spread(kActingHost, due.event, session, now, now);
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
    for (std::vector<std::byte>& bytes : m_strategy.takeDue(peer->second.participant))
        records.emplace_back(StrategyMessage{m_choice.kind, std::move(bytes)});
    if (hasLag() && now >= peer->second.nextLag) {
        records.emplace_back(LagNeeded{lagOf(&peer->second)});
        peer->second.nextLag = now + kLagInterval;
    }
    return records;
}

LocalTime HostActions::nextDue() const
{
    if (!m_handedOver.empty())
        return LocalTime::min();
    LocalTime next = std::min(m_own.nextDue(), m_strategy.nextDue());
    for (const auto& [address, peer] : m_peers)
        next = std::min({next, peer.acks.empty() ? peer.events.nextDue() : LocalTime::min(),
                         peer.relayedDue, hasLag() ? peer.nextLag : LocalTime::max()});
    return next;
}

} // namespace carina
