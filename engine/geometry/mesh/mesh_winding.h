#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// Whether the mesh encloses a volume: every edge is used equally often in both directions, so that
/// the boundary is zero. Edges of four or more triangles are allowed. False for an empty mesh.
[[nodiscard]] bool isClosed(const TriangleMesh& mesh);

/// The mesh with the winding of neighbours made to agree across every edge of two triangles. The
/// winding that most triangles of a patch have is kept. No normals.
[[nodiscard]] TriangleMesh consistentlyWound(const TriangleMesh& mesh);

/// The mesh with each part that hangs together by edges turned so that it encloses a positive
/// volume. A surface around a cavity inside another surface becomes a solid of its own.
[[nodiscard]] TriangleMesh facingOutward(const TriangleMesh& mesh);

} // namespace carina
