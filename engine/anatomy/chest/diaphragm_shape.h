#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// Signed distance to what lies below the diaphragm's two domes, in his millimetres from the lowest
/// edge of his trachea; straight down below the widest place of each.
[[nodiscard]] double belowDiaphragm(const Vec3& p);

/// The diaphragm as a sheet over both domes, from its crura and costal margin up.
[[nodiscard]] PartPlan diaphragm(const BodyPlan& plan);

} // namespace carina
