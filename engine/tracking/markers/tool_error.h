#pragma once

#include "engine/tracking/markers/probe.h"
#include "engine/tracking/tracker.h"

namespace carina
{

/// The predicted error of a tool's pose, in O, by the markers that face the tracker.
/// @param X_TO where the tool is
/// @returns nothing where its markers are not known or too few face the tracker.
[[nodiscard]] std::optional<PoseError> predictedError(const TrackedTool& tool,
                                                      const RigidTransform& X_TO);

} // namespace carina
