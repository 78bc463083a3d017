#include "engine/session/airway/airway_event_timeline.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <iterator>

namespace carina
{

AirwayEventTimeline::Severities AirwayEventTimeline::severitiesOf(const AirwayEvents& events)
{
    Severities severities{};
    for (const AirwayEvent& event : events)
        severities[static_cast<std::size_t>(event.kind)] = event.severity;
    return severities;
}

AirwayEvents AirwayEventTimeline::eventsOf(const Severities& severities)
{
    AirwayEvents events;
    for (std::size_t kind = 0; kind < severities.size(); ++kind)
        if (severities[kind] > 0.0)
            events.push_back({static_cast<AirwayEventKind>(kind), severities[kind]});
    return events;
}

AirwayEventTimeline::Severities AirwayEventTimeline::severitiesAt(const Change& change,
                                                                  SessionTime t)
{
    const Duration passed = t - change.from;
    if (passed >= change.over)
        return change.aim;
    const double share = toSeconds(passed) / toSeconds(change.over);
    Severities now{};
    for (std::size_t kind = 0; kind < now.size(); ++kind)
        now[kind] = change.begin[kind] + share * (change.aim[kind] - change.begin[kind]);
    return now;
}

std::vector<AirwayEventTimeline::Change>::const_iterator
AirwayEventTimeline::after(SessionTime t) const
{
    return std::ranges::upper_bound(m_changes, t, {}, &Change::from);
}

void AirwayEventTimeline::set(SessionTime from, const AirwayEvents& events, Duration over)
{
    CARINA_EXPECTS(areProper(events) && over >= Duration{0});
    auto place = std::ranges::lower_bound(m_changes, from, {}, &Change::from);
    if (place == m_changes.end() || place->from != from)
        place = m_changes.insert(place, Change{});
    *place = {from, over, severitiesOf(events), {}};
    for (; place != m_changes.end(); ++place)
        place->begin = place == m_changes.begin() ? Severities{}
                                                  : severitiesAt(*std::prev(place), place->from);
}

void AirwayEventTimeline::forgetBefore(SessionTime t)
{
    const auto next = after(t);
    if (next != m_changes.begin())
        m_changes.erase(m_changes.begin(), std::prev(next));
}

AirwayEvents AirwayEventTimeline::at(SessionTime t) const
{
    const auto next = after(t);
    return next == m_changes.begin() ? AirwayEvents{} : eventsOf(severitiesAt(*std::prev(next), t));
}

AirwayEvents AirwayEventTimeline::decidedAt(SessionTime t) const
{
    const auto next = after(t);
    return next == m_changes.begin() ? AirwayEvents{} : eventsOf(std::prev(next)->aim);
}

} // namespace carina
