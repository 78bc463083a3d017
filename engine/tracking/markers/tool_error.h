#pragma once

#include "engine/tracking/markers/probe.h"
#include "engine/tracking/tracker.h"

namespace carina
{

/// The predicted error of a tool's pose, in O: by the markers that it was computed from, where the
/// tracker tells them; else by all that face the tracker, where these are known; else the
/// covariance that the tracker told with the pose, as a camera does.
/// @param X_TO the pose, as it was measured
/// @returns nothing of a lost pose, where neither markers nor covariance are known, where too few
///          markers are seen, and of a partly occluded pose where it is not known by which markers:
///          all that face the tracker would make it too small.
[[nodiscard]] std::optional<PoseError> predictedError(const TrackedTool& tool,
                                                      const PoseSample& X_TO);

} // namespace carina
