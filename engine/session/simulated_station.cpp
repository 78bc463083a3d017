#include "engine/session/simulated_station.h"

#include "engine/tracking/scripted_hands.h"

#include <cmath>
#include <numbers>

namespace carina
{

namespace
{

/// In front of the carina, on the sternum.
const Vec3 kMarker_A{0.0, -0.11, -0.02};

/// Up by a half sine in a third of a breath, down in the next, and at rest.
double chestRise(Frequency rate, SessionTime t)
{
    const double breaths = rate.si * toSeconds(t.time_since_epoch());
    const double third = 3.0 * (breaths - std::floor(breaths));
    return third < 2.0 ? 0.5 * kManikinRise.si * (1.0 - std::cos(std::numbers::pi * third)) : 0.0;
}

/// The hands, and what the manikin wears: a marker on its chest and a probe on its torso.
TrueToolPose withManikin(TrueToolPose hands, const RigidTransform& X_TA, Frequency rate)
{
    return [=](ToolRole tool, SessionTime t) -> std::optional<RigidTransform> {
        if (tool == ToolRole::Manikin)
            return X_TA * simulatedBodyProbe();
        if (tool != ToolRole::Chest)
            return hands(tool, t);
        return X_TA * RigidTransform::translation(kMarker_A - chestRise(rate, t) * Vec3::UnitY());
    };
}

} // namespace

RigidTransform simulatedBodyProbe() { return RigidTransform::translation({-0.12, -0.06, 0.05}); }

Result<SimulatedStation> simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube,
                                          ReadSessionClock clock,
                                          const std::optional<StationRegistration>& registration,
                                          Frequency manikinBreathes)
{
    const RigidTransform X_TA = patientBeforeTracker(airway.p_A_incisors);
    auto hands = ScriptedHands::make({.X_TA = X_TA,
                                      .path_A = airway.path_A,
                                      .p_A_incisors = airway.p_A_incisors,
                                      .p_E_centre = tube.p_E_centre,
                                      .restAboveCarina = tube.tipAboveCarina});
    if (!hands)
        return tl::unexpected(hands.error());
    const StationRegistration exactly{.X_AT = X_TA.inverse(), .X_JA = hands->closedJaw().inverse()};
    TrueToolPose truth = withManikin(*hands, X_TA, manikinBreathes);
    SimulatedTrackerSettings device;
    device.chestMarker = manikinBreathes.si > 0.0;
    device.bodyProbe = registration && registration->X_BA;
    auto tracker = std::make_unique<SimulatedTracker>(device, truth, std::move(clock));
    return SimulatedStation{.tracking = std::make_unique<StationTracking>(
                                std::move(tracker), registration.value_or(exactly)),
                            .X_TA = X_TA,
                            .exactly = exactly,
                            .truth = std::move(truth)};
}

} // namespace carina
