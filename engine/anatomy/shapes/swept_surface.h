#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// A line through space with a direction to the side that turns with it as little as possible.
struct SweptLine {
    std::vector<double> along; ///< arc length of each point, metres, from 0
    std::vector<Vec3> points;
    std::vector<Vec3> tangents;
    std::vector<Vec3> sides; ///< unit, across the tangent
};

/// The line through these points. @pre two points at least, no two neighbours equal.
[[nodiscard]] SweptLine sweptLine(std::span<const Vec3> points);

/// A point of the line at an arc length, with its tangent and side; the ends are held.
struct LinePlace {
    Vec3 point, tangent, side;
};
[[nodiscard]] LinePlace placeAt(const SweptLine& line, double along);

/// A ring of a surface round a line.
struct Ring {
    double along = 0.0;  ///< metres of arc length
    double radius = 0.0; ///< metres
};

/// The closed surface through these rings, in their order, with flat ends and normals.
/// @pre two rings at least, ascending in `along` (equal ones make a step).
[[nodiscard]] TriangleMesh sweptSurface(const SweptLine& line, std::span<const Ring> rings);

} // namespace carina
