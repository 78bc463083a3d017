#pragma once

#include "engine/core/units.h"
#include "engine/registration/error/error_bound.h"

#include <cstddef>

namespace carina
{

/// How far touched landmarks stray from their places: the fiducial localisation error (FLE), which
/// the people, the stylus and the anatomy make together.
struct LocalisationError {
    Length rms;                     ///< root of the expected squared length of one error
    double degrees = kKnownExactly; ///< of freedom from which it was estimated

    /// The limit that the true FLE is below with a probability, and `1 - share` for the one that it
    /// is above: rms / sqrt(chiSquaredShare(degrees, 1 - share)).
    [[nodiscard]] Length limit(double share = kBoundShare) const;
};

/// The FLE of equal errors in all directions from what a fit (fitRigid) leaves of them,
///
///     FRE^2 = (1 - 2/N) FLE^2
///
/// on average (Sibson 1979; Fitzpatrick, West, Maurer 1998), with the 3 N - 6 degrees of freedom
/// that the fit leaves. It is independent of the error at any target.
///
/// @param fre rms of the fit
/// @param landmarks at least 3
[[nodiscard]] LocalisationError localisationError(Length fre, std::size_t landmarks);

/// Of two estimates of the same FLE: an earlier registration by the same hand, or what is known of
/// tracker and stylus, and the residuals of this one. The mean of the squares by their degrees of
/// freedom, which add. One that is known exactly prevails.
[[nodiscard]] LocalisationError pooled(const LocalisationError& a, const LocalisationError& b);

} // namespace carina
