#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// The mesh with vertices no further apart than `tolerance` made one (the first of them stays
/// where it is), without triangles that then have a corner twice, and without vertices that no
/// triangle uses. Of triangles on the same three vertices one is left; two that face opposite ways
/// are a fold of no thickness and both go, unless most of the surface is given from both sides.
/// No normals.
[[nodiscard]] TriangleMesh welded(const TriangleMesh& mesh, Length tolerance);

} // namespace carina
