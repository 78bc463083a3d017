#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/surface_tree.h"

namespace carina
{

/// The area-weighted mean distance from one surface to another. Every triangle is divided into
/// equal pieces with edges no longer than `spacing`, each sampled at its centre.
/// @pre both have an area, and spacing is above zero.
[[nodiscard]] Length meanDistance(const TriangleMesh& from, const SurfaceTree& to, Length spacing);

} // namespace carina
