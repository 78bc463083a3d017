#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <span>
#include <vector>

namespace carina
{

/// A line through points in one frame, metres.
using Centreline = std::vector<Vec3>;

[[nodiscard]] Length lengthOf(std::span<const Vec3> line);

/// The place a way `along` the line from its first point; the nearer end outside it.
/// @pre the line has a point.
[[nodiscard]] Vec3 pointAlong(std::span<const Vec3> line, Length along);

/// The same line with points at equal distances along it, as close as `spacing` at most; both ends
/// stay where they are.
/// @pre at least two points and spacing above zero.
[[nodiscard]] Centreline evenlySpaced(std::span<const Vec3> line, Length spacing);

} // namespace carina
