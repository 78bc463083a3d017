#include "engine/session/simulated_station.h"

#include "engine/tracking/scripted_hands.h"

namespace carina
{

Result<SimulatedStation> simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube,
                                          ReadSessionClock clock,
                                          const std::optional<StationRegistration>& registration)
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
    const StationRegistration exactly{.X_AT = X_TA.inverse(), .X_JA = hands->closedJaw().inverse()};
    auto tracker =
        std::make_unique<SimulatedTracker>(SimulatedTrackerSettings{}, *hands, std::move(clock));
    return SimulatedStation{.tracking = std::make_unique<StationTracking>(
                                std::move(tracker), registration.value_or(exactly)),
                            .X_TA = X_TA,
                            .exactly = exactly,
                            .truth = std::move(*hands)};
}

} // namespace carina
