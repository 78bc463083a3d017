#pragma once

#include "engine/airway/monitor/intubation_event.h"

#include <optional>
#include <vector>

namespace carina
{

/// Where a person says that the tube is takes, in the course of a try, the place of what a monitor
/// concluded.
///
/// What the monitor notes of the way of the tube is then left out; all else is told of the place
/// that the person named. A tube that had passed the cords, or gone behind them, by then is taken
/// to have gone there when it passed. It is told no longer once the tube is noted to be out of the
/// mouth.
class ToldPlace
{
public:
    /// @returns the steps of the course in place of what the monitor noted; often that itself
    [[nodiscard]] std::vector<IntubationEvent> noted(const IntubationEvent& event);
    /// The tube is there from now on; nothing: where the monitor notes it.
    /// @returns the steps of the course by which it gets there
    [[nodiscard]] std::vector<IntubationEvent> told(std::optional<TubeSeat> seat, SessionTime now);

    [[nodiscard]] bool isTold() const { return m_told.has_value(); }

private:
    [[nodiscard]] std::vector<IntubationEvent> between(TubeSeat from, TubeSeat to,
                                                       SessionTime at) const;

    IntubationEvent m_last;   ///< that was noted
    SessionTime m_passedAt{}; ///< when the tip came to where it is by the monitor
    std::optional<TubeSeat> m_told;
    SessionTime m_toldFrom{}; ///< when it came there
};

} // namespace carina
