#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/core/session_time.h"

#include <array>
#include <vector>

namespace carina
{

/// What was decided about the events of one patient's airway over the session, also while that is
/// paused. Before the first change the airway is clear.
///
/// Changes may be added in any order; of two at the same time the last one added holds. At any time
/// all are the same whatever the order was. A look-up takes O(log n), a change O(1) when it is the
/// newest and O(n) otherwise.
class AirwayEventTimeline
{
public:
    /// Each severity goes evenly over the time from what it is at `from` to that of these events; a
    /// later change ends that where it has come to.
    /// @pre areProper(events), and over is not negative
    void set(SessionTime from, const AirwayEvents& events, Duration over);
    /// Removes the changes before a time but the one in force then.
    /// @pre none is added any more that is earlier
    void forgetBefore(SessionTime t);

    /// The events at t, without those of severity 0.
    [[nodiscard]] AirwayEvents at(SessionTime t) const;
    /// Where the change in force at t leads to, likewise.
    [[nodiscard]] AirwayEvents decidedAt(SessionTime t) const;

private:
    /// By kind.
    using Severities = std::array<double, kAirwayEventKinds>;
    struct Change {
        SessionTime from{};
        Duration over{};
        Severities aim{};
        Severities begin{}; ///< at `from`
    };

    [[nodiscard]] static Severities severitiesOf(const AirwayEvents& events);
    [[nodiscard]] static AirwayEvents eventsOf(const Severities& severities);
    [[nodiscard]] static Severities severitiesAt(const Change& change, SessionTime t);
    [[nodiscard]] std::vector<Change>::const_iterator after(SessionTime t) const;

    std::vector<Change> m_changes; ///< in ascending order of time
};

} // namespace carina
