#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Fourteen upper and fourteen lower teeth with their roots, without wisdom teeth. The edges of the
/// two upper central incisors lie at AirwayLandmarks::p_A_incisors. The lower teeth move with the
/// mandible (heldJaw). Below kSchoolAge_years these are milk teeth, ten in a jaw, and only those
/// that have come through: none before eight months.
[[nodiscard]] std::vector<PartPlan> teeth(const BodyPlan& plan);

} // namespace carina
