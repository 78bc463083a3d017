#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Fourteen upper and fourteen lower teeth with their roots; wisdom teeth are left out. The edges
/// of the two upper central incisors lie at the landmark of the incisors. The lower ones go with
/// the lower jaw.
[[nodiscard]] std::vector<PartPlan> teeth(const BodyPlan& plan);

} // namespace carina
