#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <optional>

namespace carina
{

/// The first intersection of a ray with a mesh, as a multiple of dir_F; triangles are hit from
/// either side (Moeller and Trumbore 1997). Nothing where the ray misses the mesh.
[[nodiscard]] std::optional<double> rayHit(const TriangleMesh& mesh, const Vec3& p_F_origin,
                                           const Vec3& dir_F);

/// Distance of a point from the nearest point of a mesh's triangles, metres; infinity where the
/// mesh is empty.
[[nodiscard]] double distanceTo(const TriangleMesh& mesh, const Vec3& p_FQ);

/// Distance of a point from a box, metres; 0 inside.
[[nodiscard]] double distanceTo(const Box& box, const Vec3& p_FQ);

} // namespace carina
