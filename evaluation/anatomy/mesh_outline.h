#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <vector>

namespace carina
{

/// One closed line in which a plane cuts a surface.
struct Outline {
    std::vector<Vec3> points;
    Vec3 centroid = Vec3::Zero(); ///< of the area inside
    double area = 0.0;            ///< square metres

    /// From its first to its last point in a direction of unit length.
    [[nodiscard]] double extentAlong(const Vec3& direction) const;
};

/// Where the plane through a point, square to `normal`, cuts a closed surface whose vertices are
/// welded. Lines that do not close are left out.
[[nodiscard]] std::vector<Outline> outlinesOf(const TriangleMesh& mesh, const Vec3& p,
                                              const Vec3& normal);

} // namespace carina
