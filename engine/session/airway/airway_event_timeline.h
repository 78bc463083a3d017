#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/session/airway/ramp_timeline.h"

namespace carina
{

/// What was decided about the events of one patient's airway over the session. Before the first
/// change the airway is clear; how severities change, and how fast they are found, is that of
/// RampTimeline.
class AirwayEventTimeline
{
public:
    /// @pre areProper(events), and over is not negative
    void set(SessionTime from, const AirwayEvents& events, Duration over);
    /// As RampTimeline.
    void forgetBefore(SessionTime t) { m_severities.forgetBefore(t); }

    /// The events at t, without those of severity 0.
    [[nodiscard]] AirwayEvents at(SessionTime t) const { return eventsOf(m_severities.at(t)); }
    /// Where the change in force at t leads to, likewise.
    [[nodiscard]] AirwayEvents decidedAt(SessionTime t) const
    {
        return eventsOf(m_severities.decidedAt(t));
    }
    /// How long that change takes in all.
    [[nodiscard]] Duration overAt(SessionTime t) const { return m_severities.overAt(t); }

private:
    using Severities = RampTimeline<kAirwayEventKinds>;

    [[nodiscard]] static AirwayEvents eventsOf(const Severities::Numbers& severities);

    Severities m_severities; ///< by kind
};

} // namespace carina
