#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <cmath>

namespace carina
{

/// Coordinates of points in a room are less: squares and sums of such points stay finite.
inline constexpr Length kFarthest = metres(1e3);

/// Whether a measured point can be one in a room; false for NaN.
[[nodiscard]] inline bool isInRoom(const Vec3& p)
{
    return std::abs(p.x()) < kFarthest.si && std::abs(p.y()) < kFarthest.si
           && std::abs(p.z()) < kFarthest.si;
}

/// The same as a reason.
///
/// @returns NotFinite for NaN or infinity, OutOfRange where a coordinate is a kilometre or more.
///          The detail begins with what the point is.
[[nodiscard]] Result<void> checkPoint(const Vec3& p, const char* what);

/// Whether points spread along two directions, so that a rigid fit of them is determined.
///
/// @param scatter the mean of the outer products of their distances from their mean
/// @param whose   with which the detail begins: "the manikin's"
/// @returns DegenerateLandmarks where they lie at one place or (nearly) on one line, as
///          kSmallestExtent and kCollinearShare say (rigid_fit.h).
[[nodiscard]] Result<void> checkSpread(const Mat3& scatter, const char* whose);

/// Whether a matrix can be the covariance of where a landmark is touched.
///
/// @returns NotFinite; OutOfRange where it is not symmetric and positive definite.
[[nodiscard]] Result<void> checkCovariance(const Mat3& covariance);

} // namespace carina
