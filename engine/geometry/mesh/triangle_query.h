#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// Where the corners of one triangle lie.
struct Corners {
    Vec3 a;
    Vec3 b;
    Vec3 c;
};

[[nodiscard]] Corners cornersOf(const TriangleMesh& mesh, const Triangle& triangle);

/// The point of a triangle nearest to a point; of one without area too.
[[nodiscard]] Vec3 nearestPoint(const Corners& triangle, const Vec3& p);

/// Squared distance of a point from the nearest point of a triangle.
[[nodiscard]] double squaredDistance(const Corners& triangle, const Vec3& p);

/// Whether the inside of a segment runs through the inside of a triangle, from one side of its
/// plane to the other. What only touches or lies in the plane does not.
[[nodiscard]] bool runsThrough(const Corners& triangle, const Vec3& from, const Vec3& to);

} // namespace carina
