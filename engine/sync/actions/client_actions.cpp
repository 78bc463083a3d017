#include "engine/sync/actions/client_actions.h"

#include "engine/sync/strategies/relayed_message.h"
#include "engine/sync/wire/sequence.h"

#include <algorithm>
#include <utility>

namespace carina
{

void ClientActions::setStrategy(const StrategyChoice& choice, LocalTime now,
                                std::optional<SessionTime> session)
{
    m_choice = choice;
    beginStrategy(now);
    goOn(session, now);
}

void ClientActions::beginStrategy(LocalTime now)
{
    m_strategy.choose(m_choice, {m_actions.self(), m_others}, now);
    m_actions.show(m_strategy.view());
}

void ClientActions::setOthers(std::vector<ParticipantId> others, LocalTime now)
{
    m_others = std::move(others);
    m_strategy.setOthers(m_others, now);
}

void ClientActions::startAfresh()
{
    m_actions.clear();
    m_choice = {};
    m_strategy = {};
    m_others.clear();
    m_repeater = EventRepeater{true};
    m_adopted.clear();
    m_acks.clear();
}

void ClientActions::connected(std::optional<SessionTime> session, LocalTime now)
{
    beginStrategy(now);
    goOn(session, now);
}

void ClientActions::goOn(std::optional<SessionTime> session, LocalTime now)
{
    for (const EventCpo& event : m_actions.table().newest())
        goOn(event, session, now);
}

/// Others may still show what the strategy brought of an own object before, for instance its last
/// snapshot.
void ClientActions::goOn(const EventCpo& event, std::optional<SessionTime> session, LocalTime now)
{
    if (!session || !m_actions.isOwners(m_actions.self(), event))
        return;
    m_strategy.begin(begunFrom(evaluate(event, *session), *session, event), now);
    m_actions.show(m_strategy.view());
}

void ClientActions::disconnected(LocalTime now)
{
    beginStrategy(now);
    m_acks.clear();
    m_repeater.doubt();
}

void ClientActions::share(ObjectId object, const Ownership& ownership)
{
    if (!m_actions.share(object, ownership))
        return;
    m_strategy.forget(object);
    m_actions.show(m_strategy.view());
    if (m_actions.isOwn(object)) {
        m_adopted.push_back(object);
        return;
    }
    // What the host never had is void: it continued what it had, which may be here before the fact
    // is, or there is nothing.
    const EventCpo* newest = m_actions.table().newest(object);
    if (newest && m_repeater.awaits(object) && isAfter(ownership.epoch, newest->epoch))
        m_actions.forget(object);
    m_repeater.forget(object);
}

Result<void> ClientActions::act(ObjectId object, const ObjectAction& action, SessionTime session,
                                LocalTime now)
{
    const SessionTime start = session + std::min(longestLagOf(m_choice), m_neededLag);
    return m_actions.begun(object, action, start, now).map([&](const EventCpo& event) {
        m_actions.take(event, session, now);
        m_repeater.begin(event, now);
        m_strategy.begin(event, now);
        m_actions.show(m_strategy.view());
    });
}

void ClientActions::take(const StrategyMessage& message, LocalTime now)
{
    if (message.strategy != m_choice.kind)
        return; // sent before its author knew that there is another
    const auto relayed = decodeRelayed(message.bytes);
    const auto* action = relayed ? std::get_if<EventCpo>(&relayed->content) : nullptr;
    if (relayed && (!action || m_actions.isOwners(relayed->from, *action)))
        m_strategy.receive(message.bytes, now);
}

void ClientActions::take(const EventCpo& event, std::optional<SessionTime> session, LocalTime now)
{
    const auto verdict = m_actions.take(event, session, now);
    if (verdict == EventTable::Verdict::Refused)
        return;
    m_acks.emplace_back(EventAck{event.object, event.epoch, event.action});
    // An action of its own that it does not know, from before it was started, or from the last
    // owner: it is this node's to keep alive.
    if (verdict == EventTable::Verdict::New && m_actions.isOwn(event.object)) {
        m_repeater.begin(event, now);
        goOn(event, session, now);
    }
}

void ClientActions::take(const EventBeat& beat, std::optional<SessionTime> session, LocalTime now)
{
    if (const EventCpo* event = m_actions.table().named(beat))
        take(EventCpo{*event}, session, now);
}

std::vector<WireRecord> ClientActions::takeDue(LocalTime now)
{
    std::vector<WireRecord> records = std::exchange(m_acks, {});
    for (const ObjectId object : std::exchange(m_adopted, {}))
        if (const EventCpo* event = m_actions.table().newest(object);
            event && m_actions.isOwners(m_actions.self(), *event))
            m_repeater.begin(*event, now);
    for (const DueEvent& due : m_repeater.takeDue(now))
        records.push_back(due.record());
    for (std::vector<std::byte>& bytes : m_strategy.takeDue(now))
        records.emplace_back(StrategyMessage{m_choice.kind, std::move(bytes)});
    m_actions.show(m_strategy.view());
    return records;
}

LocalTime ClientActions::nextDue() const
{
    return m_acks.empty() && m_adopted.empty()
               ? std::min(m_repeater.nextDue(), m_strategy.nextDue())
               : LocalTime::min();
}

} // namespace carina
