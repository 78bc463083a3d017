#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/session/station_tracking.h"
#include "engine/tracking/simulated_tracker.h"

namespace carina
{

/// A station without hardware: the simulated tracker watches a scripted pair of hands that brings
/// the tube into this patient again and again, where the manikin breathes a marker on its chest,
/// and where it was registered with a body probe that probe.
struct SimulatedStation {
    std::unique_ptr<StationTracking> tracking;
    RigidTransform X_TA;         ///< where the manikin truly lies
    StationRegistration exactly; ///< the registration without any error
    TrueToolPose truth;          ///< X_T<tool> of the hands, whatever the tracker measures
};

/// @param registration of the manikin; without one it is registered exactly. Has it X_BA, the
///        manikin wears a body probe, which truly is at simulatedBodyProbe()
/// @param manikinBreathes its chest rises by kManikinRise so often; 0: it does not, and has no
///        marker
/// @returns what ScriptedHands::make refuses of this airway.
[[nodiscard]] Result<SimulatedStation>
simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube, ReadSessionClock clock,
                 const std::optional<StationRegistration>& registration = {},
                 Frequency manikinBreathes = {});

inline constexpr Length kManikinRise = millimetres(12.0);

/// X_AB of the body probe that a simulated manikin may wear: on its right shoulder, with the axes
/// of A.
[[nodiscard]] RigidTransform simulatedBodyProbe();

} // namespace carina
