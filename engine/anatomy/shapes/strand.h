#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"

#include <span>
#include <vector>

namespace carina
{

/// A place on a strand: half its width, half its thickness, and the direction in which it is thin.
struct StrandPoint {
    Vec3 p;
    double wide = 0.0;
    double thin = 0.0;
    Vec3 thinAxis = Vec3::UnitY(); ///< unit
};

/// A flat rod along a line, with rounded edges and ends: a rib, a breastbone, a muscle.
class Strand
{
public:
    /// @pre two points at least, no two neighbours in one place.
    explicit Strand(std::vector<StrandPoint> points);

    [[nodiscard]] double distance(const Vec3& p) const;
    [[nodiscard]] Box bounds() const;
    [[nodiscard]] ImplicitShape shape() const;

private:
    std::vector<StrandPoint> m_points;
};

/// A smooth line in `pieces` steps from one point to another that leaves along `leaving` and
/// arrives along `arriving`, whose lengths say how far they are followed (cubic Hermite); the last
/// point is left to the next line.
[[nodiscard]] std::vector<Vec3> smoothLine(const Vec3& from, const Vec3& leaving, const Vec3& to,
                                           const Vec3& arriving, int pieces);

/// A smooth line through all points (Catmull and Rom 1974), `pieces` steps between two of them.
/// @pre two points at least.
[[nodiscard]] std::vector<Vec3> smoothThrough(std::span<const Vec3> points, int pieces);

/// A round rod along a line with another radius at every point; the union of its pieces.
[[nodiscard]] double tubeDistance(const Vec3& p, std::span<const Vec3> line,
                                  std::span<const double> radii);

} // namespace carina
