#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// Skin of head, neck and torso to below the ribs, without arms: a plain body that encloses
/// everything else, thicker over the ribs the more fat there is.
[[nodiscard]] PartPlan skin(const BodyPlan& plan);

} // namespace carina
