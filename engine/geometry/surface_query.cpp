#include "engine/geometry/surface_query.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

struct Corners {
    Vec3 a;
    Vec3 b;
    Vec3 c;
};

Corners cornersOf(const TriangleMesh& mesh, const Triangle& triangle)
{
    return {mesh.positions[triangle[0]].cast<double>(), mesh.positions[triangle[1]].cast<double>(),
            mesh.positions[triangle[2]].cast<double>()};
}

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

double squaredToEdge(const Vec3& p, const Vec3& from, const Vec3& to)
{
    const Vec3 edge = to - from;
    const double length2 = edge.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp(edge.dot(p - from) / length2, 0.0, 1.0) : 0.0;
    return (p - from - share * edge).squaredNorm();
}

double squaredDistance(const Corners& t, const Vec3& p)
{
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    const auto leftOf = [&](const Vec3& from, const Vec3& to) {
        return normal.dot((to - from).cross(p - from)) >= 0.0;
    };
    if (normal.squaredNorm() > 0.0 && leftOf(t.a, t.b) && leftOf(t.b, t.c) && leftOf(t.c, t.a)) {
        const double height = normal.dot(p - t.a);
        return height * height / normal.squaredNorm();
    }
    return std::min(
        {squaredToEdge(p, t.a, t.b), squaredToEdge(p, t.b, t.c), squaredToEdge(p, t.c, t.a)});
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
