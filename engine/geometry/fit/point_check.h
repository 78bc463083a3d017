#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

namespace carina
{

/// Upper limit of the coordinates of a valid point; squares and sums of such points stay finite.
inline constexpr Length kFarthest = metres(1e3);

/// Whether a point is finite and its coordinates are below kFarthest.
///
/// @param what name of the point, with which the detail begins
/// @returns NotFinite for NaN or infinity, OutOfRange where a coordinate is a kilometre or more.
[[nodiscard]] Result<void> checkPoint(const Vec3& p, const char* what);

/// Whether points extend along at least two directions, so that a rigid fit of them is determined.
///
/// @param scatter the mean of the outer products of their differences from their mean, m^2
/// @param whose   owner of the points, with which the detail begins: "the manikin's"
/// @returns DegenerateLandmarks where they are coincident (kSmallestExtent) or nearly collinear
///          (kCollinearShare, both in rigid_fit.h).
[[nodiscard]] Result<void> checkSpread(const Mat3& scatter, const char* whose);

/// Whether a matrix is a valid covariance of a landmark's position.
///
/// @returns NotFinite; OutOfRange where it is not symmetric or not positive definite.
[[nodiscard]] Result<void> checkCovariance(const Mat3& covariance);

} // namespace carina
