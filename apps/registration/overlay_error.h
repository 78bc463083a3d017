#pragma once

#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// How far from its place on the manikin a point of the anatomy is drawn, metres:
///
///     | X_AT X_TA p_AQ - p_AQ |
///
/// @param X_AT the registration that is drawn by
/// @param X_TA where the anatomy truly lies before the tracker
[[nodiscard]] double overlayError(const RigidTransform& X_AT, const RigidTransform& X_TA,
                                  const Vec3& p_AQ);

} // namespace carina
