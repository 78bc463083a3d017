#include "engine/sync/connection/shown_relay.h"

#include <algorithm>

namespace carina
{

void ShownRelay::take(const ShownPose& shown, ParticipantId from, LocalTime now)
{
    Entry& entry = m_entries[shown.object];
    const bool isOld =
        entry.waiting && entry.waiting->from == from && entry.waiting->shown.at >= shown.at;
    if (isOld)
        return;
    entry.waiting = Passed{shown, from};
    m_nextDue = std::min(m_nextDue, std::max(entry.next, now));
}

std::vector<ShownRelay::Passed> ShownRelay::takeDue(LocalTime now)
{
    std::vector<Passed> due;
    if (now < m_nextDue)
        return due;
    for (Entry* const entry : ready(now)) {
        if (!m_room.takeOf(kMostAtOnce, 1.0, kMostPerS, now)) {
            m_nextDue = std::min(m_nextDue, now + kWait);
            break;
        }
        due.push_back(*entry->waiting);
        entry->waiting.reset();
        entry->next = now + kInterval;
    }
    return due;
}

std::vector<ShownRelay::Entry*> ShownRelay::ready(LocalTime now)
{
    std::vector<Entry*> found;
    m_nextDue = LocalTime::max();
    for (auto& [object, entry] : m_entries) {
        if (!entry.waiting)
            continue;
        if (now < entry.next)
            m_nextDue = std::min(m_nextDue, entry.next);
        else
            found.push_back(&entry);
    }
    std::ranges::stable_sort(found, {}, &Entry::next);
    return found;
}

} // namespace carina
