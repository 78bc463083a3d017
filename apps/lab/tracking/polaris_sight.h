#pragma once

#include "apps/lab/tracking/polaris_tools.h"
#include "evaluation/polaris/polaris_poses.h"

#include <functional>

namespace carina::lab
{

/// The pose of a tool, by its number among the tools before the device; nothing while it is not
/// seen.
using SeenPose = std::function<std::optional<PolarisPose>(std::size_t tool, LocalTime t)>;

/// The tools of the simulated tracker that are before the device.
[[nodiscard]] std::vector<NamedTool> scriptedTools();

/// What the simulated tracker measures of scripted hands at the manikin of kPatient: the poses of
/// scriptedTools(), from these markers, with its noise.
/// @returns the errors of making the patient and of ScriptedHands::make.
[[nodiscard]] Result<SeenPose> scriptedSight(const Words& words, const PolarisTools& tools);

/// What was recorded, again and again.
[[nodiscard]] SeenPose recordedSight(const TrackerSequence& sequence);

} // namespace carina::lab
