#include "engine/geometry/mesh/surface_query.h"

#include "engine/geometry/mesh/triangle_query.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

std::optional<double> rayHit(const Corners& t, const Vec3& p_origin, const Vec3& dir)
{
    const Vec3 ab = t.b - t.a;
    const Vec3 ac = t.c - t.a;
    const Vec3 normal = dir.cross(ac);
    const double determinant = ab.dot(normal);
    if (determinant == 0.0) // along the triangle's plane
        return std::nullopt;
    const Vec3 fromA = p_origin - t.a;
    const double u = fromA.dot(normal) / determinant;
    const Vec3 across = fromA.cross(ab);
    const double v = dir.dot(across) / determinant;
    const double along = ac.dot(across) / determinant;
    const bool inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    return inside && along >= 0.0 ? std::optional{along} : std::nullopt;
}

} // namespace

std::optional<double> rayHit(const TriangleMesh& mesh, const Vec3& p_F_origin, const Vec3& dir_F)
{
    std::optional<double> nearest;
    for (const Triangle& triangle : mesh.triangles) {
        const auto hit = rayHit(cornersOf(mesh, triangle), p_F_origin, dir_F);
        if (hit && (!nearest || *hit < *nearest))
            nearest = hit;
    }
    return nearest;
}

double distanceTo(const TriangleMesh& mesh, const Vec3& p_FQ)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : mesh.triangles)
        nearest = std::min(nearest, squaredDistance(cornersOf(mesh, triangle), p_FQ));
    return std::sqrt(nearest);
}

double distanceTo(const Box& box, const Vec3& p_FQ)
{
    return (p_FQ - p_FQ.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

} // namespace carina
