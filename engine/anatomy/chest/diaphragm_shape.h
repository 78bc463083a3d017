#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// Signed distance to the space below the two domes of the diaphragm, which goes on straight down
/// below the widest section of each. Point and result in reference millimetres of the chest
/// (BodyPlan).
[[nodiscard]] double belowDiaphragm(const Vec3& p);

/// The diaphragm as a sheet over both domes, upwards from its crura and the costal margin.
[[nodiscard]] PartPlan diaphragm(const BodyPlan& plan);

} // namespace carina
