#pragma once

#include "engine/core/units.h"
#include "engine/registration/fit/rigid_fit.h"

#include <optional>

namespace carina
{

/// How far each landmark lies from where the fit of all others puts it, metres. A landmark that was
/// touched at a wrong place draws the fit of all to itself and hides; from that of the others it
/// stands out.
///
/// @returns in the pairs' order, nothing where the others alone determine no fit (three, or on one
///          line); what fitRigid returns for all of them.
[[nodiscard]] Result<std::vector<std::optional<double>>>
leaveOneOut(std::span<const LandmarkPair> pairs);

/// A landmark whose touch all others contradict.
struct OutlyingLandmark {
    std::size_t landmark = 0; ///< by its place among the pairs
    Length distance;          ///< of its touch from where the fit of all others puts it
};

/// Share of sound sets of touches in which a landmark is called outlying all the same.
inline constexpr double kOutlierFalseAlarm = 0.01;

/// The landmark that stands out most, if it does. Its distance is compared with the bound of what
/// the others leave open, of their fit's error at it and of a touch,
///
///     cov = pointCovariance(fitCovariance(FLE), p_AQ) + FLE^2 / 3,
///
/// FLE and its degrees of freedom by the residuals of the others, at a share of
/// 1 - kOutlierFalseAlarm / N (Bonferroni, for the N landmarks that are asked).
///
/// @returns nothing where none stands out, and where no fit of others exists.
[[nodiscard]] std::optional<OutlyingLandmark> outlyingLandmark(std::span<const LandmarkPair> pairs);

} // namespace carina
