#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <cmath>

namespace carina
{

/// The working volume of a tracker: a cone 1.5 m high with a base radius of 0.5 m (Hamza-Lup,
/// Rolland and Hughes 2004). The apex is the origin of T and the axis is -z of T, the viewing
/// direction of an NDI Polaris: visible points have negative z.
struct WorkingVolume {
    Length height = metres(1.5);
    Length baseRadius = metres(0.5);

    /// Whether a point Q lies inside or on the surface; metres.
    [[nodiscard]] bool contains(const Vec3& p_TQ) const
    {
        const double depth = -p_TQ.z();
        const double radius = std::hypot(p_TQ.x(), p_TQ.y());
        return depth >= 0.0 && depth <= height.si && radius * height.si <= baseRadius.si * depth;
    }
};

} // namespace carina
