#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/session/simulated_tools.h"
#include "engine/tracking/simulated/simulated_tracker.h"
#include "engine/tracking/simulated/stylus_hand.h"

#include <memory>

namespace carina
{

/// A manikin with a chin probe in front of a simulated tracker, a hand that holds a stylus, and on
/// the tracker's side of the manikin a tube and a laryngoscope, which lie still.
struct SimulatedWorkplace {
    RigidTransform X_TA;            ///< true pose of the anatomy
    Vec3 p_TQ_divot = Vec3::Zero(); ///< beside the manikin
    SimulatedTools tools;
    RigidTransform X_TN_tube;         ///< the markers of the tube
    RigidTransform X_TN_laryngoscope; ///< the markers of the laryngoscope
    std::shared_ptr<StylusHand> hand; ///< shared with the tracker's thread, which reads it
    std::unique_ptr<SimulatedTracker> tracker;
    ReadSessionClock clock; ///< of the tracker's samples
};

/// The clock of the samples of every workplace, so that one recording goes through several.
[[nodiscard]] std::optional<SessionTime> workplaceNow();

/// @returns the errors of ScriptedHands::make.
[[nodiscard]] Result<SimulatedWorkplace> simulatedWorkplace(const AirwayLandmarks& airway,
                                                            const TubeShape& tube,
                                                            SimulatedTrackerSettings device = {});

} // namespace carina
