#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/tracking/simulated_tracker.h"
#include "engine/tracking/stylus_hand.h"

#include <memory>

namespace carina
{

/// A manikin with a chin probe before a simulated tracker, and a hand that holds a stylus.
struct SimulatedWorkplace {
    RigidTransform X_TA;              ///< where the anatomy truly lies
    Vec3 p_TQ_divot = Vec3::Zero();   ///< beside the manikin
    std::shared_ptr<StylusHand> hand; ///< shared with the tracker's thread, which asks it
    std::unique_ptr<SimulatedTracker> tracker;
    ReadSessionClock clock; ///< of the tracker's samples
};

/// @returns what ScriptedHands::make returns.
[[nodiscard]] Result<SimulatedWorkplace> simulatedWorkplace(const AirwayLandmarks& airway,
                                                            const TubeShape& tube);

} // namespace carina
