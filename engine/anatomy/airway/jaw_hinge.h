#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// X_AJ of the lower jaw in the plan's posture, the identity with the mouth shut: a turn about the
/// line through both condyles, which opens the incisors by 20 mm in an adult.
[[nodiscard]] RigidTransform heldJaw(const BodyPlan& plan);

/// From a place in the mouth that is shut to where the lower jaw takes it in the plan's posture.
[[nodiscard]] Vec3 withJaw(const BodyPlan& plan, const Vec3& p_A_shut);

/// A shape that is written for a mouth that is shut, as the lower jaw takes it.
[[nodiscard]] ImplicitShape onJaw(const BodyPlan& plan, ImplicitShape shut);

} // namespace carina
