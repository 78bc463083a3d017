#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"

namespace carina
{

/// The edge of the lower incisors with the mouth closed, from that of the upper ones, in reference
/// millimetres (BodyPlan).
inline const Vec3 kUpperToLowerIncisors{0.0, 4.0, 0.5};

/// The mandible without its teeth, in A: the horseshoe-shaped body, and the rami with coronoid and
/// condylar processes.
///
/// @param p_A_lowerIncisors  edge of the lower incisors, in the midline, metres
/// @param size               factor of all lengths; 1 for the adult
[[nodiscard]] ImplicitShape mandibleShape(const Vec3& p_A_lowerIncisors, double size);

} // namespace carina
