#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// How far two views of one object for one time are apart.
struct Drift {
    Angle rotation;  ///< of q_s q_c^-1
    Length position; ///< between the origins
};

/// @param X_AO_sent as its owner had it
/// @param X_AO_shown as a viewer had it for the same time, before it heard
[[nodiscard]] Drift driftBetween(const RigidTransform& X_AO_sent, const RigidTransform& X_AO_shown);

} // namespace carina
