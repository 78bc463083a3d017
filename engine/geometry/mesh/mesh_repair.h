#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// The vertices around one hole, in the direction in which the adjacent triangles use its edges.
using BoundaryLoop = std::vector<std::uint32_t>;

/// The holes of a mesh with consistent winding. An edge that is used more often in one direction
/// than in the other counts once for every excess use. Holes that share a vertex are separated, so
/// that no loop visits a vertex twice. Deterministic.
[[nodiscard]] std::vector<BoundaryLoop> boundaryLoops(const TriangleMesh& mesh);

/// The mesh with every hole filled, wound like the triangles around it; `isClosed` afterwards if
/// its winding was consistent. A loop is filled by its triangulation of least area without new
/// vertices, which also suits non-planar loops (Barequet and Sharir 1995); a loop of more than 256
/// edges is filled by a fan about a new vertex at its mean. The result has no normals.
[[nodiscard]] TriangleMesh capped(const TriangleMesh& mesh);

/// The mesh welded, consistently wound, capped and facing outward. `isClosed` unless empty.
[[nodiscard]] TriangleMesh closedSurface(const TriangleMesh& mesh, Length weldTolerance);

} // namespace carina
