#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <limits>

namespace carina
{

/// Degrees of freedom of a variance that is given and not estimated.
inline constexpr double kKnownExactly = std::numeric_limits<double>::infinity();

/// The share of errors that a bound holds, unless another is said.
inline constexpr double kBoundShare = 0.95;

/// The length that a Gaussian error of mean 0 stays below with a probability.
///
/// Along a direction n the squared length is r^2 n^T C n, with r^2 chi-squared of three degrees of
/// freedom; where C was estimated from `degrees` degrees of freedom, and is independent of the
/// error, r^2 / 3 follows F(3, degrees) instead. The bound solves
///
///     mean over all n of P(r^2 <= b^2 / n^T C n) = share
///
/// to a thousandth from three degrees of freedom on: Student's t where one direction has all of the
/// error, Fisher's F where all directions are alike. For three alike that are known, b = 1.61 RMS;
/// no bound of 95 % is below that.
///
/// @param covariance m^2, symmetric
/// @param degrees    above 0
/// @param share      between 0 and 1
[[nodiscard]] Length errorBound(const Mat3& covariance, double degrees = kKnownExactly,
                                double share = kBoundShare);

/// The quantile of chi-squared over its degrees of freedom: with this probability a variance that
/// is estimated from so many is less than this times the true one.
/// @param degrees above 0
/// @param share   between 0 and 1
[[nodiscard]] double chiSquaredShare(double degrees, double share);

/// The probability that chi-squared is more than this.
/// @param chiSquared 0 or more
/// @param degrees    above 0
[[nodiscard]] double chiSquaredTail(double chiSquared, double degrees);

} // namespace carina
