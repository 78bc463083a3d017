#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// Vertices around one hole, in the order and direction in which the triangles beside the hole run.
using BoundaryLoop = std::vector<std::uint32_t>;

/// The holes of a mesh with consistent winding. An edge that is used more often in one direction
/// than in the other counts once for every excess use; at a vertex that several holes share they
/// are separated, so that no loop visits a vertex twice. Deterministic.
[[nodiscard]] std::vector<BoundaryLoop> boundaryLoops(const TriangleMesh& mesh);

/// The mesh with every hole covered, wound like the triangles around it; `isClosed` afterwards when
/// its winding was consistent. A loop is covered by its triangulation of least area, without new
/// vertices, which suits loops that lie in no plane (Barequet and Sharir 1995); a loop longer than
/// 256 edges by a fan about a new vertex at its mean. No normals.
[[nodiscard]] TriangleMesh capped(const TriangleMesh& mesh);

/// All of it: welded, consistently wound, capped and facing outward. `isClosed` unless empty.
[[nodiscard]] TriangleMesh closedSurface(const TriangleMesh& mesh, Length weldTolerance);

} // namespace carina
