#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// The mesh with vertices at most `tolerance` apart merged into one, at the position of the first
/// of them. Removed are triangles that then have the same vertex twice, vertices that no triangle
/// uses, and all but one of the triangles on the same three vertices. Two triangles on the same
/// vertices that face opposite ways are a fold without thickness: both are removed, unless most of
/// the surface is given two-sided. The result has no normals.
/// @pre the tolerance is not negative.
[[nodiscard]] TriangleMesh welded(const TriangleMesh& mesh, Length tolerance);

} // namespace carina
