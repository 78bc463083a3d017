#include "engine/sync/strategies/action_meter.h"

#include "engine/sync/actions/shared_actions.h"

#include <algorithm>

namespace carina
{
namespace
{

/// As it is drawn.
ActedPose evaluated(const EventCpo& event, SessionTime t)
{
    ActedPose acted = evaluate(event, t);
    acted.scale =
        std::clamp(acted.scale, SharedActions::kSmallestScale, SharedActions::kLargestScale);
    return acted;
}

Drift driftAfter(const EventCpo& event, const EventCpo& before, Duration delay)
{
    if (delay == Duration{})
        return {}; // where it puts the object elsewhere that was meant, and drawn in time
    const SessionTime t = event.start + delay;
    return driftBetween(evaluated(event, t), evaluated(before, t));
}

} // namespace

void ActionMeter::arrived(const EventCpo& event, const EventCpo& before, SessionTime now)
{
    const Duration delay = std::max(now - event.start, Duration{});
    std::erase_if(m_arrivals, [&](const Arrival& past) { return now - past.at > kWindow; });
    if (m_arrivals.size() == kMostKept)
        m_arrivals.erase(m_arrivals.begin());
    m_arrivals.push_back({now, event.epoch, delay});
    Duration shortest = delay;
    for (const Arrival& past : m_arrivals)
        if (past.epoch == event.epoch)
            shortest = std::min(shortest, past.delay);
    m_figures = {driftAfter(event, before, shortest), delay};
    m_arrivals.back().limit = m_figures.limit;
}

Drift ActionMeter::limitAt(SessionTime t) const
{
    Drift largest{};
    for (const Arrival& past : m_arrivals) {
        if (t < past.at - past.delay || t >= past.at)
            continue;
        largest.rotation = std::max(largest.rotation, past.limit.rotation);
        largest.position = std::max(largest.position, past.limit.position);
        largest.scale = std::max(largest.scale, past.limit.scale);
    }
    return largest;
}

} // namespace carina
