#include "engine/session/simulated_station.h"

#include "engine/tracking/scripted_hands.h"

namespace carina
{

Result<std::unique_ptr<StationTracking>>
simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube, ReadSessionClock clock)
{
    const RigidTransform X_TA = patientBeforeTracker(airway.p_A_incisors);
    auto hands = ScriptedHands::make({.X_TA = X_TA,
                                      .path_A = airway.path_A,
                                      .p_A_incisors = airway.p_A_incisors,
                                      .p_E_tip = tube.p_E_tip,
                                      .dir_E_tip = tube.dir_E_tip,
                                      .restAboveCarina = tube.tipAboveCarina});
    if (!hands)
        return tl::unexpected(hands.error());
    const RigidTransform X_JA = hands->closedJaw().inverse();
    auto tracker = std::make_unique<SimulatedTracker>(SimulatedTrackerSettings{}, std::move(*hands),
                                                      std::move(clock));
    return std::make_unique<StationTracking>(
        std::move(tracker), StationRegistration{.X_AT = X_TA.inverse(), .X_JA = X_JA});
}

} // namespace carina
