#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// The skin of head, neck and torso down to below the ribs, without arms: a simplified body that
/// encloses all other parts, at a distance from the ribs that grows with the fat layer. It has a
/// face: nose, brow, shut lids, cheeks, chin and ears; between the lips it is not open.
[[nodiscard]] PartPlan skin(const BodyPlan& plan);

} // namespace carina
