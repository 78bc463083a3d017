#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <span>
#include <vector>

namespace carina
{

/// A polyline through points in one frame, metres.
using Centreline = std::vector<Vec3>;

/// Its arc length.
[[nodiscard]] Length lengthOf(std::span<const Vec3> line);

/// The point at arc length `along` from the first point; clamped to both ends.
/// @pre the line has at least one point.
[[nodiscard]] Vec3 pointAlong(std::span<const Vec3> line, Length along);

/// The same line, resampled to points at equal arc lengths of at most `spacing`; both ends are
/// kept.
/// @pre at least two points and spacing above zero.
[[nodiscard]] Centreline evenlySpaced(std::span<const Vec3> line, Length spacing);

} // namespace carina
