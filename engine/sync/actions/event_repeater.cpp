#include "engine/sync/actions/event_repeater.h"

#include "engine/sync/wire/sequence.h"

#include <algorithm>

namespace carina
{

bool isLater(const EventCpo& a, const EventCpo& b)
{
    if (a.epoch != b.epoch)
        return isAfter(a.epoch, b.epoch);
    return a.action != b.action ? isAfter(a.action, b.action) : a.start > b.start;
}

WireRecord DueEvent::record() const
{
    if (isBeat)
        return EventBeat{event.object, event.epoch, event.action};
    return event;
}

void EventRepeater::begin(const EventCpo& event, LocalTime due)
{
    const auto found = m_entries.find(event.object);
    if (found != m_entries.end() && found->second.lastSent == LocalTime::min())
        due = std::min(due, found->second.due);
    m_entries.insert_or_assign(event.object, Entry{event, due, due});
}

void EventRepeater::beat(const EventCpo& event, LocalTime due)
{
    const auto found = m_entries.find(event.object);
    if (found != m_entries.end() && found->second.due > due
        && found->second.lastSent != LocalTime::min()
        && due - found->second.lastSent >= kShortestBeat)
        found->second.due = due;
}

bool EventRepeater::awaits(ObjectId object) const
{
    const auto found = m_entries.find(object);
    return found != m_entries.end() && !found->second.isAcknowledged;
}

void EventRepeater::acknowledge(const EventAck& ack)
{
    const auto found = m_entries.find(ack.object);
    if (found == m_entries.end())
        return;
    Entry& entry = found->second;
    if (ack.epoch != entry.event.epoch || ack.action != entry.event.action)
        return;
    entry.beatsForNothing = 0;
    if (entry.isAcknowledged)
        return;
    entry.isAcknowledged = true;
    entry.due = m_hasHeartbeat ? entry.lastSent + kHeartbeat : LocalTime::max();
}

void EventRepeater::doubt()
{
    for (auto& [object, entry] : m_entries)
        entry.beatsForNothing = kUnanswered;
}

LocalTime EventRepeater::dueAfter(const Entry& entry, LocalTime now) const
{
    if (entry.isAcknowledged)
        return m_hasHeartbeat ? now + kHeartbeat : LocalTime::max();
    LocalTime next = entry.begun + kFirstRepeat;
    if (now >= next)
        next += kRepeat * ((now - next) / kRepeat + 1);
    return next;
}

std::vector<DueEvent> EventRepeater::takeDue(LocalTime now)
{
    std::vector<DueEvent> due;
    for (auto& [object, entry] : m_entries) {
        if (now < entry.due)
            continue;
        const bool isBeat = entry.isAcknowledged && entry.beatsForNothing < kUnanswered;
        due.push_back({entry.event, isBeat});
        if (isBeat)
            ++entry.beatsForNothing;
        entry.lastSent = now;
        entry.due = dueAfter(entry, now);
    }
    return due;
}

LocalTime EventRepeater::nextDue() const
{
    LocalTime next = LocalTime::max();
    for (const auto& [object, entry] : m_entries)
        next = std::min(next, entry.due);
    return next;
}

} // namespace carina
