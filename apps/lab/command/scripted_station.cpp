#include "apps/lab/command/scripted_station.h"

#include "engine/anatomy/patient/builtin_patient.h"

#include <utility>

namespace carina::lab
{

Result<ScriptedStation> scriptedStation(const PatientParameters& parameters)
{
    const auto dimensions = dimensionsFor(parameters);
    if (!dimensions)
        return tl::unexpected(dimensions.error());
    const auto patient = patientFor(parameters);
    if (!patient)
        return tl::unexpected(patient.error());
    const AirwayLandmarks& airway = patient->landmarks;
    const auto tube = makeTube(dimensions->tubeInnerDiameter, airway.path_A, airway.p_A_incisors,
                               usualTipAboveCarina(dimensions->tubeInnerDiameter));
    if (!tube)
        return tl::unexpected(tube.error());
    auto station = simulatedStation(airway, *tube, [] { return std::optional<SessionTime>{}; });
    if (!station)
        return tl::unexpected(station.error());
    return ScriptedStation{airway, *std::move(station)};
}

} // namespace carina::lab
