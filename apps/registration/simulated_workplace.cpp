#include "apps/registration/simulated_workplace.h"

#include "engine/core/monotonic_clock.h"
#include "engine/geometry/rotation.h"
#include "engine/tracking/simulated/scripted_hands.h"

#include <numbers>

namespace carina
{
namespace
{

const Vec3 kTip_S{0.0, 0.0, -0.150};  ///< of the stylus, below its markers
const Vec3 kParked{0.13, 0.0, -0.05}; ///< of the markers from the incisors, in A
const Vec3 kDivot{0.14, 0.05, -0.08}; ///< from the incisors, in A
const Vec3 kTubeMarkers{0.2, 0.02, 0.1};
const Vec3 kLaryngoscopeMarkers{0.1, 0.1, 0.1}; ///< where the tracker sees it

/// The stylus upright over the patient, who lies: +z of S anterior, -y of A.
RigidTransform parkedStylus(const Vec3& p_A_incisors)
{
    return {rotationFromVector(0.5 * std::numbers::pi * Vec3::UnitX()), p_A_incisors + kParked};
}

} // namespace

std::optional<SessionTime> workplaceNow() { return SessionTime{monotonicNow().time_since_epoch()}; }

Result<SimulatedWorkplace> simulatedWorkplace(const AirwayLandmarks& airway, const TubeShape& tube,
                                              SimulatedTrackerSettings device)
{
    const Vec3& p_A_incisors = airway.p_A_incisors;
    const RigidTransform X_TA = patientBeforeTracker(p_A_incisors);
    const auto hands = ScriptedHands::make({.X_TA = X_TA,
                                            .path_A = airway.path_A,
                                            .p_A_incisors = p_A_incisors,
                                            .p_E_centre = tube.p_E_centre,
                                            .restAboveCarina = tube.tipAboveCarina});
    if (!hands)
        return tl::unexpected(hands.error());
    const RigidTransform X_TJ = X_TA * hands->closedJaw();
    auto hand = std::make_shared<StylusHand>(X_TA * parkedStylus(p_A_incisors), kTip_S);
    const RigidTransform X_TN_tube =
        X_TA * RigidTransform::translation(p_A_incisors + kTubeMarkers);
    const RigidTransform X_TN_laryngoscope =
        X_TA * RigidTransform::translation(p_A_incisors + kLaryngoscopeMarkers);
    const auto truth = [=](ToolRole tool, SessionTime t) -> std::optional<RigidTransform> {
        if (tool == ToolRole::Jaw)
            return X_TJ;
        if (tool == ToolRole::Tube)
            return X_TN_tube;
        if (tool == ToolRole::Laryngoscope)
            return X_TN_laryngoscope;
        return tool == ToolRole::Stylus ? std::optional{hand->at(t)} : std::nullopt;
    };
    device.laryngoscope = true;
    auto tracker = std::make_unique<SimulatedTracker>(device, truth, workplaceNow);
    return SimulatedWorkplace{.X_TA = X_TA,
                              .p_TQ_divot = X_TA * Vec3{p_A_incisors + kDivot},
                              .tools = simulatedTools(tube),
                              .X_TN_tube = X_TN_tube,
                              .X_TN_laryngoscope = X_TN_laryngoscope,
                              .hand = std::move(hand),
                              .tracker = std::move(tracker),
                              .clock = workplaceNow};
}

} // namespace carina
