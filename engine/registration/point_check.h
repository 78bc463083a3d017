#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"

namespace carina
{

/// Whether a measured point can be one in a room: squares and sums of such points stay finite.
///
/// @returns NotFinite for NaN or infinity, OutOfRange where a coordinate is a kilometre or more.
///          The detail begins with what the point is.
[[nodiscard]] Result<void> checkPoint(const Vec3& p, const char* what);

} // namespace carina
