#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/session/simulated_station.h"

namespace carina::lab
{

/// A made patient at a station with scripted hands, of which the truth is asked and not the
/// tracker, which has no clock.
struct ScriptedStation {
    AirwayLandmarks airway; ///< of the patient
    SimulatedStation station;
};

/// @returns OutOfRange for a patient there is not; what making it, its tube or the hands fails with
[[nodiscard]] Result<ScriptedStation> scriptedStation(const PatientParameters& parameters);

} // namespace carina::lab
