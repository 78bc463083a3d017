#include "engine/geometry/mesh/triangle_query.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

Vec3 nearestOfEdge(const Vec3& p, const Vec3& from, const Vec3& to)
{
    const Vec3 edge = to - from;
    const double length2 = edge.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp(edge.dot(p - from) / length2, 0.0, 1.0) : 0.0;
    return from + share * edge;
}

/// Six times the signed volume of a tetrahedron.
double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return (b - a).cross(c - a).dot(d - a);
}

} // namespace

Corners cornersOf(const TriangleMesh& mesh, const Triangle& triangle)
{
    return {mesh.positions[triangle[0]].cast<double>(), mesh.positions[triangle[1]].cast<double>(),
            mesh.positions[triangle[2]].cast<double>()};
}

Vec3 nearestPoint(const Corners& t, const Vec3& p)
{
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    const auto leftOf = [&](const Vec3& from, const Vec3& to) {
        return normal.dot((to - from).cross(p - from)) >= 0.0;
    };
    if (normal.squaredNorm() > 0.0 && leftOf(t.a, t.b) && leftOf(t.b, t.c) && leftOf(t.c, t.a))
        return p - normal.dot(p - t.a) / normal.squaredNorm() * normal;
    const std::array<Vec3, 3> ofEdges{nearestOfEdge(p, t.a, t.b), nearestOfEdge(p, t.b, t.c),
                                      nearestOfEdge(p, t.c, t.a)};
    return *std::ranges::min_element(
        ofEdges, {}, [&p](const Vec3& nearest) { return (p - nearest).squaredNorm(); });
}

double squaredDistance(const Corners& t, const Vec3& p)
{
    return (p - nearestPoint(t, p)).squaredNorm();
}

bool runsThrough(const Corners& t, const Vec3& from, const Vec3& to)
{
    if (volumeOf(t.a, t.b, t.c, from) * volumeOf(t.a, t.b, t.c, to) >= 0.0)
        return false;
    const double ab = volumeOf(from, to, t.a, t.b);
    const double bc = volumeOf(from, to, t.b, t.c);
    const double ca = volumeOf(from, to, t.c, t.a);
    return (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
}

} // namespace carina
