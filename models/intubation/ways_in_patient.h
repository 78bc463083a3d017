#pragma once

#include "engine/airway/monitor/patient_ways.h"
#include "models/patient/patient_model.h"

#include <vector>

namespace carina
{

/// The ways of a tube in a patient, as its surfaces are made (patientWays); one that lacks an
/// epiglottis, cords or a soft palate has those of its landmarks.
/// @pre the landmarks' path has two points at least, on either side of the glottis
[[nodiscard]] PatientWays waysOf(const PatientModel& patient);

/// The centre line of the patient's tube in A, from connector to tip, as it is measured with its
/// connector at X_AE: rigid, and bent as the neck is where it was made to fit the airway
/// (centreIn).
[[nodiscard]] std::vector<Vec3> measuredTube(const PatientModel& patient, const NeckField& neck,
                                             const RigidTransform& X_AE);

} // namespace carina
