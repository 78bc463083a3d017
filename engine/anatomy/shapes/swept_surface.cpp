#include "engine/anatomy/shapes/swept_surface.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr std::uint32_t kCorners = 24; ///< of one ring

void addRing(TriangleMesh& mesh, const LinePlace& place, double radius)
{
    const Vec3 across = place.tangent.cross(place.side);
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kCorners;
        const Vec3 out = std::cos(angle) * place.side + std::sin(angle) * across;
        mesh.positions.push_back((place.point + radius * out).cast<float>());
    }
}

/// Triangles between two rings that begin at these vertices.
void addBand(TriangleMesh& mesh, std::uint32_t first, std::uint32_t second)
{
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const std::uint32_t next = (k + 1) % kCorners;
        mesh.triangles.push_back({first + k, first + next, second + next});
        mesh.triangles.push_back({first + k, second + next, second + k});
    }
}

/// Closes a ring with a fan about a vertex in its middle.
void addEnd(TriangleMesh& mesh, std::uint32_t ring, const Vec3& middle, bool facesForward)
{
    const auto centre = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(middle.cast<float>());
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const std::uint32_t next = (k + 1) % kCorners;
        if (facesForward)
            mesh.triangles.push_back({centre, ring + k, ring + next});
        else
            mesh.triangles.push_back({centre, ring + next, ring + k});
    }
}

} // namespace

SweptLine sweptLine(std::span<const Vec3> points)
{
    CARINA_EXPECTS(points.size() >= 2);
    SweptLine line;
    line.along = {0.0};
    line.points = {points.begin(), points.end()};
    for (std::size_t i = 1; i < points.size(); ++i)
        line.along.push_back(line.along.back() + (points[i] - points[i - 1]).norm());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& before = points[i > 0 ? i - 1 : 0];
        const Vec3& after = points[std::min(i + 1, points.size() - 1)];
        line.tangents.push_back((after - before).normalized());
    }
    carrySide(line, line.tangents.front().unitOrthogonal());
    return line;
}

/// From point to point by the turn of the tangent alone.
void carrySide(SweptLine& line, const Vec3& side)
{
    line.sides = {side};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const Quat turn = Quat::FromTwoVectors(line.tangents[i - 1], line.tangents[i]);
        line.sides.push_back((turn * line.sides.back()).normalized());
    }
}

LinePlace placeAt(const SweptLine& line, double along)
{
    const auto after = std::ranges::upper_bound(line.along, along);
    const auto i = std::clamp<std::ptrdiff_t>(after - line.along.begin(), 1,
                                              std::ptrdiff_t(line.along.size()) - 1);
    const auto k = std::size_t(i);
    const double step = line.along[k] - line.along[k - 1];
    const double s = std::clamp((along - line.along[k - 1]) / step, 0.0, 1.0);
    const auto between = [&](const std::vector<Vec3>& values) -> Vec3 {
        return values[k - 1] + s * (values[k] - values[k - 1]);
    };
    const Vec3 tangent = between(line.tangents).normalized();
    const Vec3 side = between(line.sides);
    return {between(line.points), tangent, (side - side.dot(tangent) * tangent).normalized()};
}

TriangleMesh sweptSurface(const SweptLine& line, std::span<const Ring> rings)
{
    CARINA_EXPECTS(rings.size() >= 2);
    TriangleMesh mesh;
    for (const Ring& ring : rings)
        addRing(mesh, placeAt(line, ring.along), ring.radius);
    const auto last = static_cast<std::uint32_t>((rings.size() - 1) * kCorners);
    for (std::uint32_t first = 0; first < last; first += kCorners)
        addBand(mesh, first, first + kCorners);
    addEnd(mesh, 0, placeAt(line, rings.front().along).point, false);
    addEnd(mesh, last, placeAt(line, rings.back().along).point, true);
    computeNormals(mesh);
    return mesh;
}

} // namespace carina
