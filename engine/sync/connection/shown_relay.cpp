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
    m_nextDue = LocalTime::max();
    for (auto& [object, entry] : m_entries) {
        if (!entry.waiting)
            continue;
        if (now < entry.next) {
            m_nextDue = std::min(m_nextDue, entry.next);
            continue;
        }
        due.push_back(*entry.waiting);
        entry.waiting.reset();
        entry.next = now + kInterval;
    }
    return due;
}

} // namespace carina
