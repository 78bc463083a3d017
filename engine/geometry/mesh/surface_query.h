#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <optional>

namespace carina
{

/// How far along a ray a mesh is first met, in units of the direction's length; from either side of
/// its triangles. Nothing where the ray misses it. (Moeller and Trumbore 1997.)
[[nodiscard]] std::optional<double> rayHit(const TriangleMesh& mesh, const Vec3& p_F_origin,
                                           const Vec3& dir_F);

/// Distance of a point from the nearest point of a mesh's triangles, metres; infinity where it has
/// none.
[[nodiscard]] double distanceTo(const TriangleMesh& mesh, const Vec3& p_FQ);

/// Distance of a point from a box, metres; 0 inside.
[[nodiscard]] double distanceTo(const Box& box, const Vec3& p_FQ);

} // namespace carina
