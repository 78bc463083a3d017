#pragma once

#include "engine/airway/monitor/patient_ways.h"
#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/deformation/throat_field.h"

namespace carina
{

/// The ways of a patient (patientWays) as they are drawn.
/// @param changes of the airway by events
/// @param throat  where jaw and neck have taken it
/// @param tissue  as a blade pushes it
[[nodiscard]] PatientWays drawnWays(const PatientWays& ways, const AirwayField& changes,
                                    const FollowingThroat& throat, const BladeField& tissue);

} // namespace carina
