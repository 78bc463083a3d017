#pragma once

#include "engine/airway/monitor/intubation_event.h"

#include <optional>
#include <vector>

namespace carina
{

/// Where a person says that a tube in the mouth is takes, in the course of a try, the place of what
/// a monitor concluded.
///
/// What the monitor notes of the way of the tube is then left out; all else is told of the place
/// that the person named. What is said holds since the tip came to where the monitor has it: past
/// the level of the cords, or back above it; where the monitor has it above them, since it is said.
/// So is what is said next, or that nothing is said any more, and of what is taken back nothing is
/// left. The first breath since then is that of the present place. A tube that is noted to be out
/// of the mouth is no longer told.
class ToldPlace
{
public:
    /// @returns the steps of the course in place of what the monitor noted; often that itself
    [[nodiscard]] std::vector<IntubationEvent> noted(const IntubationEvent& event);
    /// The tube is there; nothing: where the monitor notes it.
    /// @returns the steps of the course by which it gets there
    [[nodiscard]] std::vector<IntubationEvent> told(std::optional<TubeSeat> seat,
                                                    SessionTime since);

    [[nodiscard]] bool isTold() const { return m_told.has_value(); }

private:
    [[nodiscard]] std::vector<IntubationEvent> between(TubeSeat from, TubeSeat to,
                                                       SessionTime at) const;
    [[nodiscard]] IntubationEvent asTold(IntubationEvent event) const;

    IntubationEvent m_last; ///< that was noted
    /// When the tip passed the level of the cords last, by the monitor.
    SessionTime m_passedAt{};
    std::optional<IntubationEvent> m_breath; ///< the first since then, as it was noted
    std::optional<TubeSeat> m_told;
};

} // namespace carina
