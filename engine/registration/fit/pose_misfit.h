#pragma once

#include "engine/geometry/fit/rigid_fit.h"

namespace carina
{

/// The sum of squared residuals of the best rigid fit: the minimum over all X_AM of
///
///     sum_i | p_AQ_i - X_AM * p_MQ_i |^2      m^2
///
/// computed from the singular values s of the cross-covariance matrix and the sums of squares A and
/// M about the means of both sets: A + M - 2 (s_1 + s_2 +- s_3), minus where the determinant is
/// negative (Umeyama 1991). Unlike fitRigid it needs no unique best pose: two pairs are compared by
/// their distance, collinear points by their positions on the line; for one pair or none the result
/// is 0.
///
/// @pre all coordinates are less than kFarthest.
[[nodiscard]] double poseMisfit(std::span<const LandmarkPair> pairs);

/// The quantile of chi-squared below which a misfit counts as plausible.
inline constexpr double kPlausibleShare = 0.999;

/// Largest plausible difference between the distance of two touches and that of their landmarks, in
/// standard deviations.
inline constexpr double kFarthestDeviations = 5.0;

} // namespace carina
