#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"

namespace carina
{

/// The lower jaw without its teeth, in A: the horseshoe of the body, the rami with coronoid and
/// condylar process.
///
/// @param p_A_lowerIncisors  edge of the lower incisors, in the midline
/// @param size               1 for the adult; lengths go with it
[[nodiscard]] ImplicitShape mandibleShape(const Vec3& p_A_lowerIncisors, double size);

} // namespace carina
