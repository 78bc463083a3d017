#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <limits>

namespace carina
{

/// Degrees of freedom of a variance that is known and not estimated.
inline constexpr double kKnownExactly = std::numeric_limits<double>::infinity();

/// The default probability of a bound.
inline constexpr double kBoundShare = 0.95;

/// The length that a Gaussian error vector of mean 0 stays below with probability `share`.
///
/// With C the covariance, the error is r C^1/2 n, where n is a unit vector of uniform direction and
/// r^2 is chi-squared with three degrees of freedom; where C was estimated with `degrees` degrees
/// of freedom, independently of the error, r^2 / 3 follows F(3, degrees) instead. The bound solves
///
///     mean over all n of P(r^2 <= b^2 / n^T C n) = share
///
/// to a relative accuracy of 1e-3 from three degrees of freedom on. Special cases are Student's t,
/// where the error has one direction, and Fisher's F, where it is isotropic. For an isotropic known
/// covariance the bound of 95 % is 1.61 RMS, and none is smaller.
///
/// @param covariance m^2, symmetric
/// @param degrees    above 0
/// @param share      between 0 and 1
[[nodiscard]] Length errorBound(const Mat3& covariance, double degrees = kKnownExactly,
                                double share = kBoundShare);

/// The `share` quantile of chi-squared, divided by its degrees of freedom: with this probability an
/// estimated variance is less than this factor times the true one.
/// @param degrees above 0
/// @param share   between 0 and 1
[[nodiscard]] double chiSquaredShare(double degrees, double share);

/// The probability that a chi-squared variable exceeds this value.
/// @param chiSquared 0 or more
/// @param degrees    above 0
[[nodiscard]] double chiSquaredTail(double chiSquared, double degrees);

/// The probability that the ratio of two estimates of the same variance, with these degrees of
/// freedom above and below, exceeds a value: the tail of Fisher's F.
/// @param ratio 0 or more
/// @param above, below above 0
[[nodiscard]] double varianceRatioTail(double ratio, double above, double below);

} // namespace carina
