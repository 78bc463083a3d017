#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <functional>
#include <span>

namespace carina
{

using Vec2 = Eigen::Vector2d;

/// A solid as a function: negative inside, positive outside, and near the surface approximately the
/// signed distance to it, metres.
using Implicit = std::function<double(const Vec3&)>;

/// A solid and a box that contains it.
struct ImplicitShape {
    Box bounds;
    Implicit distance; ///< Lipschitz constant at most 2
};

/// A place around which the grid of a mesh has smaller cells: `share` of their size there, of all
/// directions alike, and growing towards their size over about `reach` metres. A share of 1 is an
/// even grid.
struct FinePlace {
    Vec3 p = Vec3::Zero();
    double share = 1.0;
    double reach = 1.0;
};

/// Smooth maximum and minimum of two distances, which are blended where they differ by less than
/// `blend` (Quilez' polynomial blend): intersection and union of two solids with a fillet.
[[nodiscard]] double roundedMax(double a, double b, double blend);
[[nodiscard]] double roundedMin(double a, double b, double blend);

/// Smooth step: 0 up to `from`, 1 from `to` on, and 3 t^2 - 2 t^3 between.
[[nodiscard]] double easedStep(double from, double to, double x);

/// Distance to a rod with round ends from a to b, of radius ra at a and rb at b.
[[nodiscard]] double rodDistance(const Vec3& p, const Vec3& a, const Vec3& b, double ra, double rb);

/// Distance to an ellipsoid about the origin, to first order: exact on the surface.
[[nodiscard]] double ellipsoidDistance(const Vec3& p, const Vec3& radii);
/// The same for an ellipse.
[[nodiscard]] double ellipseDistance(const Vec2& p, const Vec2& radii);

/// Signed distance to a simple polygon, whose corners may have either orientation.
[[nodiscard]] double polygonDistance(const Vec2& p, std::span<const Vec2> corners);

/// A point relative to a polyline: the arc length of its nearest point, and its distance.
struct AlongLine {
    double along;
    double off;
};
/// Coordinates of p relative to the polyline through `points`, extended straight beyond the last.
/// @pre at least two points, no two neighbours equal.
[[nodiscard]] AlongLine alongLine(const Vec2& p, std::span<const Vec2> points);

/// Chaikin's corner cutting (1974), `times` times: each segment is replaced by its points at a
/// quarter and three quarters. Both ends are kept; the result converges to a smooth curve.
[[nodiscard]] std::vector<Vec2> cornersCut(std::vector<Vec2> points, int times);

} // namespace carina
