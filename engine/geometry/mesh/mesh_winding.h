#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// Whether the mesh encloses a volume: every edge is used equally often in both directions, so that
/// the surface has no boundary. Edges of four or more triangles are allowed. False for an empty
/// mesh.
[[nodiscard]] bool isClosed(const TriangleMesh& mesh);

/// The mesh with consistent winding: triangles agree across every edge that exactly two of them
/// use. Each patch that is connected by such edges keeps the winding of the majority of its
/// triangles. The result has no normals.
[[nodiscard]] TriangleMesh consistentlyWound(const TriangleMesh& mesh);

/// The mesh with each part that is connected by edges oriented so that its signed volume is not
/// negative. The surface of a cavity inside another surface thereby becomes a solid of its own. The
/// result has no normals.

[[nodiscard]] TriangleMesh facingOutward(const TriangleMesh& mesh);

} // namespace carina
