#pragma once

#include "engine/registration/fit/rigid_fit.h"

namespace carina
{

/// What the best pose leaves of pairs: the least value, over all X_AM, of
///
///     sum_i | p_AQ_i - X_AM * p_MQ_i |^2      m^2
///
/// from the singular values s of the cross-covariance and the sums of squares about the means,
/// A + M - 2 (s_1 + s_2 +- s_3) (Umeyama 1991). Unlike fitRigid it needs no one best pose: of two
/// pairs it compares their distance, of points on one line their places on it; of none or one it is
/// 0.
///
/// @pre all coordinates are less than kFarthest.
[[nodiscard]] double poseMisfit(std::span<const LandmarkPair> pairs);

/// Share of sound sets of touches that leave less than what still counts as plausible.
inline constexpr double kPlausibleShare = 0.999;

/// Standard deviations by which a distance between touches may differ from its landmarks'.
inline constexpr double kFarthestDeviations = 5.0;

} // namespace carina
