#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// X_AJ of the mandible in the plan's posture: the identity with the mouth closed, otherwise a
/// rotation about the line through both condyles that opens the incisors by 20 mm in an adult.
[[nodiscard]] RigidTransform heldJaw(const BodyPlan& plan);

/// Moves a shape, given for the closed mouth, with the mandible to the plan's posture.
[[nodiscard]] ImplicitShape onJaw(const BodyPlan& plan, ImplicitShape shut);

} // namespace carina
