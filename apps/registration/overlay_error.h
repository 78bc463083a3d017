#pragma once

#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The overlay error of a point of the anatomy, the distance between its drawn and its true
/// position, metres:
///
///     | X_AT X_TA p_AQ - p_AQ |
///
/// @param X_AT the registration used for drawing
/// @param X_TA the true pose of the anatomy in the tracker frame
[[nodiscard]] double overlayError(const RigidTransform& X_AT, const RigidTransform& X_TA,
                                  const Vec3& p_AQ);

} // namespace carina
