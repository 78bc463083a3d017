#pragma once

#include "engine/anatomy/body_plan.h"

namespace carina
{

/// From a place in the mouth that is shut to where the lower jaw takes it in the plan's posture: a
/// turn about the line through both condyles, which opens the incisors by 20 mm in an adult.
[[nodiscard]] Vec3 withJaw(const BodyPlan& plan, const Vec3& p_A_shut);

/// A shape that is written for a mouth that is shut, as the lower jaw takes it.
[[nodiscard]] ImplicitShape onJaw(const BodyPlan& plan, ImplicitShape shut);

} // namespace carina
