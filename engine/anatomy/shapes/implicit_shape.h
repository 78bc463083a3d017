#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <functional>
#include <span>

namespace carina
{

using Vec2 = Eigen::Vector2d;

/// A solid given by a function: below zero inside, above zero outside, about the distance to the
/// surface near it, in metres.
using Implicit = std::function<double(const Vec3&)>;

/// A solid and the box that holds it.
struct ImplicitShape {
    Box bounds;
    Implicit distance; ///< differs by at most 2 metres for each metre between two points
};

/// The larger and the smaller of two distances, rounded over where they differ by less than `blend`
/// (Quilez' polynomial blend): the intersection and the union of two solids with a fillet.
[[nodiscard]] double roundedMax(double a, double b, double blend);
[[nodiscard]] double roundedMin(double a, double b, double blend);

/// 0 at `from` or before, 1 at `to` or beyond, with a smooth cubic between.
[[nodiscard]] double easedStep(double from, double to, double x);

/// A rod with round ends from a to b, of radius ra at a and rb at b.
[[nodiscard]] double rodDistance(const Vec3& p, const Vec3& a, const Vec3& b, double ra, double rb);

/// An ellipsoid about the origin. Exact on the surface and along it to first order.
[[nodiscard]] double ellipsoidDistance(const Vec3& p, const Vec3& radii);
/// The same for an ellipse.
[[nodiscard]] double ellipseDistance(const Vec2& p, const Vec2& radii);

/// Signed distance to a simple polygon, corners in either order.
[[nodiscard]] double polygonDistance(const Vec2& p, std::span<const Vec2> corners);

/// A point beside a line through several points: how far along and how far off.
struct AlongLine {
    double along;
    double off;
};
/// The nearest place on the line through `points`, which goes on straight beyond its last one.
/// @pre at least two points, no two neighbours equal.
[[nodiscard]] AlongLine alongLine(const Vec2& p, std::span<const Vec2> points);

/// The line with its corners cut off at a quarter and three quarters of each step, `times` times;
/// both ends stay (Chaikin 1974). Tends to a smooth curve.
[[nodiscard]] std::vector<Vec2> cornersCut(std::vector<Vec2> points, int times);

} // namespace carina
