#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace carina
{

/// Everything that moves in a scene, at one time.
struct SceneFrame {
    SessionTime time{}; ///< for which this holds

    /// Of the right and the left lung, dimensionless, for the level of detail that was asked for.
    std::array<double, 2> amplitude{};

    /// X_AF of each moving body's frame F, by name. A body that is not in here is not drawn: lost
    /// is never an identity.
    std::map<std::string, RigidTransform> bodies;

    /// X_AD of the eye, where a view follows one: D is right-handed with +x to the right, +y up and
    /// the line of sight along -z.
    std::optional<RigidTransform> X_AD;
};

/// One frame that was drawn.
struct DrawnFrame {
    SceneFrame frame;    ///< what was drawn
    int level = 0;       ///< in which level of detail
    LocalTime asked{};   ///< when the frame source was asked
    LocalTime swapped{}; ///< when the buffers had been swapped
};

} // namespace carina
