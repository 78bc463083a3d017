#include "engine/sync/actions/event_table.h"

#include <algorithm>

namespace carina
{

/// Keeps what is in force until the new action starts.
void EventTable::Entry::supersede(const EventCpo& event, std::optional<SessionTime> session)
{
    before.push_back(std::exchange(newest, event));
    const SessionTime now = std::min(session.value_or(event.start), event.start);
    while (before.size() > kMostPending || (before.size() > 1 && before[1].start <= now))
        before.pop_front();
}

EventTable::Verdict EventTable::take(const EventCpo& event, std::optional<SessionTime> session,
                                     LocalTime now)
{
    if (session && event.start > *session + kLargestLead)
        return Verdict::Refused;
    const auto [place, isNew] = m_entries.try_emplace(event.object, Entry{event, {}, now});
    if (isNew)
        return Verdict::New;
    Entry& entry = place->second;
    if (isLater(event, entry.newest)) {
        entry.supersede(event, session);
        entry.heard = now;
        return Verdict::New;
    }
    if (isLater(entry.newest, event))
        return Verdict::Old;
    entry.heard = now;
    return Verdict::Known;
}

const EventCpo* EventTable::inForce(ObjectId object, SessionTime t) const
{
    const auto found = m_entries.find(object);
    if (found == m_entries.end())
        return nullptr;
    const Entry& entry = found->second;
    if (entry.before.empty() || t >= entry.newest.start)
        return &entry.newest;
    const auto started = std::find_if(entry.before.rbegin(), entry.before.rend(),
                                      [t](const EventCpo& event) { return t >= event.start; });
    return started == entry.before.rend() ? &entry.before.front() : &*started;
}

bool EventTable::isStale(ObjectId object, LocalTime t) const
{
    const auto found = m_entries.find(object);
    return found != m_entries.end() && t - found->second.heard > kStaleAfter;
}

const EventCpo* EventTable::newest(ObjectId object) const
{
    const auto found = m_entries.find(object);
    return found == m_entries.end() ? nullptr : &found->second.newest;
}

const EventCpo* EventTable::named(const EventBeat& beat) const
{
    const EventCpo* event = newest(beat.object);
    return event && event->epoch == beat.epoch && event->action == beat.action ? event : nullptr;
}

std::vector<EventCpo> EventTable::newest() const
{
    std::vector<EventCpo> events;
    for (const auto& [object, entry] : m_entries)
        events.push_back(entry.newest);
    return events;
}

} // namespace carina
