#pragma once

#include "engine/geometry/deformation/neck_field.h"
#include "engine/session/airway/ramp_timeline.h"

namespace carina
{

/// What was decided about how head and neck of one patient lie over the session. They are in
/// neutral position before the first change; how the angles change, and how fast they are found, is
/// that of RampTimeline.
class HeadPositionTimeline
{
public:
    /// @pre the angles are finite, and over is not negative
    void set(SessionTime from, const HeadPosition& position, Duration over)
    {
        m_angles.set(from, {position.flexion.si, position.extension.si}, over);
    }
    /// As RampTimeline.
    void forgetBefore(SessionTime t) { m_angles.forgetBefore(t); }

    [[nodiscard]] HeadPosition at(SessionTime t) const { return positionOf(m_angles.at(t)); }
    /// Where the change in force at t leads to.
    [[nodiscard]] HeadPosition decidedAt(SessionTime t) const
    {
        return positionOf(m_angles.decidedAt(t));
    }
    /// How long that change takes in all.
    [[nodiscard]] Duration overAt(SessionTime t) const { return m_angles.overAt(t); }

private:
    using Angles = RampTimeline<2>;

    [[nodiscard]] static HeadPosition positionOf(const Angles::Numbers& angles)
    {
        return {radians(angles[0]), radians(angles[1])};
    }

    Angles m_angles; ///< flexion and extension, radians
};

} // namespace carina
