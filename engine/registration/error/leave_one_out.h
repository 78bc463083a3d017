#pragma once

#include "engine/core/units.h"
#include "engine/geometry/fit/rigid_fit.h"

#include <optional>

namespace carina
{

/// The leave-one-out distance of each landmark: from its touch to where the fit of all other
/// landmarks predicts it, metres. A landmark that was touched at a wrong place pulls a fit that
/// includes it towards itself, so that its residual there is too small.
///
/// @returns the distances in the pairs' order, nothing where the other pairs do not determine a fit
///          (as with three landmarks, or the others on one line); the error of fitRigid where all
///          pairs together cannot be fitted.
[[nodiscard]] Result<std::vector<std::optional<double>>>
leaveOneOut(std::span<const LandmarkPair> pairs);

/// A landmark whose touch disagrees with all others.
struct OutlyingLandmark {
    std::size_t landmark = 0; ///< index among the pairs
    Length distance;          ///< its leave-one-out distance
};

/// False alarm rate: share of sets without an outlier in which one is reported.
inline constexpr double kOutlierFalseAlarm = 0.01;

/// The landmark with the largest leave-one-out distance relative to its standard deviation, if it
/// is an outlier: if the distance is above the errorBound of the error of the others' fit at the
/// landmark plus that of one touch,
///
///     cov = pointCovariance(fitCovariance(FLE), p_AQ) + FLE^2 / 3,
///
/// with FLE (at least kLeastFle) and its degrees of freedom from the residuals of the others, and a
/// probability of 1 - kOutlierFalseAlarm / N (Bonferroni correction for N landmarks).
///
/// @returns nothing where there is no outlier, or where no fit of the others exists.
[[nodiscard]] std::optional<OutlyingLandmark> outlyingLandmark(std::span<const LandmarkPair> pairs);

} // namespace carina
