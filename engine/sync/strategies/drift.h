#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/sync/wire/event_cpo.h"

namespace carina
{

/// Difference between two poses of one object for the same time.
struct Drift {
    Angle rotation;     ///< of q_s q_c^-1, sent and shown
    Length position;    ///< between the origins
    double scale = 0.0; ///< the larger size by the smaller, less 1
};

/// @param X_AO_sent pose at the owner
/// @param X_AO_shown pose that a viewer drew for the same time, before the update arrived
[[nodiscard]] Drift driftBetween(const RigidTransform& X_AO_sent, const RigidTransform& X_AO_shown);
/// The same with the sizes.
[[nodiscard]] Drift driftBetween(const ActedPose& sent, const ActedPose& shown);

} // namespace carina
