#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/surface_tree.h"

namespace carina
{

/// Mean over the area of one surface of the distance to another. Sampled evenly: every triangle in
/// equal pieces with edges no longer than `spacing`, each at its middle.
/// @pre both have an area, and spacing is above zero.
[[nodiscard]] Length meanDistance(const TriangleMesh& from, const SurfaceTree& to, Length spacing);

} // namespace carina
