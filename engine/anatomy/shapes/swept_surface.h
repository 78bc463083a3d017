#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// A polyline with a side direction that rotates about it as little as possible.
struct SweptLine {
    std::vector<double> along; ///< arc length of each point, metres, from 0
    std::vector<Vec3> points;
    std::vector<Vec3> tangents; ///< unit
    std::vector<Vec3> sides;    ///< unit, perpendicular to the tangent
};

/// The line through these points. @pre at least two points, no two neighbours equal.
[[nodiscard]] SweptLine sweptLine(std::span<const Vec3> points);
/// Gives the line another side at its beginning, and carries that along it.
/// @pre the side is perpendicular to the first tangent, of length 1
void carrySide(SweptLine& line, const Vec3& side);

/// A point of the line with its tangent and side.
struct LinePlace {
    Vec3 point, tangent, side;
};
/// The point at an arc length, metres; clamped to both ends.
[[nodiscard]] LinePlace placeAt(const SweptLine& line, double along);

/// A circular section of a surface around a line.
struct Ring {
    double along = 0.0;  ///< metres of arc length
    double radius = 0.0; ///< metres
};

/// The closed surface through these rings, in their order, with flat ends and with normals.
/// @pre at least two rings, in ascending order of `along` (equal values make a step).
[[nodiscard]] TriangleMesh sweptSurface(const SweptLine& line, std::span<const Ring> rings);

} // namespace carina
