#pragma once

#include "engine/tracking/markers/probe.h"
#include "engine/tracking/tracker.h"

namespace carina
{

/// The predicted error of a tool's pose, in O: by the markers that face the tracker, where these
/// are known; else the covariance that the tracker told with the newest sample, as a camera does.
/// @param X_TO where the tool is
/// @returns nothing where neither is known, too few markers face the tracker, or it is not seen.
[[nodiscard]] std::optional<PoseError> predictedError(const TrackedTool& tool,
                                                      const RigidTransform& X_TO);

} // namespace carina
