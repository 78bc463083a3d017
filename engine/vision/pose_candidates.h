#pragma once

#include "engine/vision/body_pose.h"

#include <vector>

namespace carina
{

/// The closed-form poses of a body for corners seen, unrefined: two for corners in a plane, from
/// which one is tilted to the wrong side; one or more otherwise.
[[nodiscard]] std::vector<RigidTransform> poseCandidates(const CameraModel& camera,
                                                         std::span<const SeenCorner> corners);

} // namespace carina
