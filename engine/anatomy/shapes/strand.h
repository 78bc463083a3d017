#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"

#include <span>
#include <vector>

namespace carina
{

/// A point of a strand's centre line with the size of its section, metres.
struct StrandPoint {
    Vec3 p;
    double wide = 0.0;             ///< half its width
    double thin = 0.0;             ///< half its thickness
    Vec3 thinAxis = Vec3::UnitY(); ///< unit direction of the thickness
};

/// A flat rod along a polyline, with rounded edges and ends: a rib, a sternum, a muscle.
class Strand
{
public:
    /// @pre at least two points, no two neighbours equal.
    explicit Strand(std::vector<StrandPoint> points);

    /// Approximate signed distance (see Implicit).
    [[nodiscard]] double distance(const Vec3& p) const;
    [[nodiscard]] Box bounds() const;
    [[nodiscard]] ImplicitShape shape() const;

private:
    std::vector<StrandPoint> m_points;
};

/// A cubic Hermite curve in `pieces` steps from one point to another, with the derivatives
/// `leaving` and `arriving` at its ends. The last point is not included, so that curves can be
/// joined.
[[nodiscard]] std::vector<Vec3> smoothLine(const Vec3& from, const Vec3& leaving, const Vec3& to,
                                           const Vec3& arriving, int pieces);

/// A smooth curve through all points (Catmull and Rom 1974), with `pieces` steps between two of
/// them.
/// @pre at least two points.
[[nodiscard]] std::vector<Vec3> smoothThrough(std::span<const Vec3> points, int pieces);

/// Distance to a round rod along a polyline with a radius for each point: the union of tapered
/// rods.
[[nodiscard]] double tubeDistance(const Vec3& p, std::span<const Vec3> line,
                                  std::span<const double> radii);

} // namespace carina
