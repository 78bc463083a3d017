#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Tongue, hard palate, soft palate with the uvula, and the space between them: the oral cavity,
/// from the teeth back to the pharynx, as a solid of its own.
[[nodiscard]] std::vector<PartPlan> mouth(const BodyPlan& plan);

} // namespace carina
