#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/tube.h"
#include "engine/session/station_tracking.h"
#include "engine/tracking/simulated_tracker.h"

namespace carina
{

/// A station without hardware: the simulated tracker watches a scripted pair of hands that brings
/// the tube into this patient again and again. It is registered exactly.
///
/// @returns what ScriptedHands::make refuses of this airway.
[[nodiscard]] Result<std::unique_ptr<StationTracking>>
simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube, ReadSessionClock clock);

} // namespace carina
