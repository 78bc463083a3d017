#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Tongue, hard palate, soft palate with the uvula, and the oral cavity between them, from the
/// teeth back to the pharynx, as a separate solid.
[[nodiscard]] std::vector<PartPlan> mouth(const BodyPlan& plan);

} // namespace carina
