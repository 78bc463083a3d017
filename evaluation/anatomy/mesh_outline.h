#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <vector>

namespace carina
{

/// One closed curve in which a plane cuts a surface.
struct Outline {
    std::vector<Vec3> points;
    Vec3 centroid = Vec3::Zero(); ///< of the area inside
    double area = 0.0;            ///< square metres

    /// The extent in metres, from the least to the greatest projection on a unit direction.
    [[nodiscard]] double extentAlong(const Vec3& direction) const;
};

/// The curves in which the plane through p perpendicular to `normal` cuts a closed surface with
/// welded vertices. Curves that do not close are left out.
[[nodiscard]] std::vector<Outline> outlinesOf(const TriangleMesh& mesh, const Vec3& p,
                                              const Vec3& normal);

} // namespace carina
