#include "engine/session/airway/airway_event_timeline.h"

#include "engine/core/expects.h"

namespace carina
{

void AirwayEventTimeline::set(SessionTime from, const AirwayEvents& events, Duration over)
{
    CARINA_EXPECTS(areProper(events));
    Severities::Numbers severities{};
    for (const AirwayEvent& event : events)
        severities[static_cast<std::size_t>(event.kind)] = event.severity;
    m_severities.set(from, severities, over);
}

AirwayEvents AirwayEventTimeline::eventsOf(const Severities::Numbers& severities)
{
    AirwayEvents events;
    for (std::size_t kind = 0; kind < severities.size(); ++kind)
        if (severities[kind] > 0.0)
            events.push_back({static_cast<AirwayEventKind>(kind), severities[kind]});
    return events;
}

} // namespace carina
