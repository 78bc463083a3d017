#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// The positions of one triangle's corners.
struct Corners {
    Vec3 a;
    Vec3 b;
    Vec3 c;
};

/// The corners of a triangle of a mesh, in double precision.
[[nodiscard]] Corners cornersOf(const TriangleMesh& mesh, const Triangle& triangle);

/// The point of a triangle nearest to p; also for a degenerate triangle.
[[nodiscard]] Vec3 nearestPoint(const Corners& triangle, const Vec3& p);

/// Squared distance of p from the nearest point of a triangle.
[[nodiscard]] double squaredDistance(const Corners& triangle, const Vec3& p);

/// Whether the interior of a segment passes through the interior of a triangle, from one side of
/// its plane to the other. Touching it, or lying in its plane, does not count.
[[nodiscard]] bool runsThrough(const Corners& triangle, const Vec3& from, const Vec3& to);

} // namespace carina
