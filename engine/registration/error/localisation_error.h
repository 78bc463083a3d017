#pragma once

#include "engine/core/units.h"
#include "engine/registration/error/error_bound.h"

#include <cstddef>

namespace carina
{

/// The fiducial localisation error (FLE): the distance of touched landmarks from their true places,
/// caused by person, stylus and anatomy together.
struct LocalisationError {
    Length rms;                     ///< root mean square length of the error of one touch
    double degrees = kKnownExactly; ///< degrees of freedom of the estimate

    /// The limit that the true FLE stays below with probability `share`:
    /// rms / sqrt(chiSquaredShare(degrees, 1 - share)); rms where the FLE is known exactly.
    [[nodiscard]] Length limit(double share = kBoundShare) const;
};

/// The FLE from the FRE of a fit of equal weights (fitRigid), for equal isotropic errors:
///
///     FRE^2 = (1 - 2/N) FLE^2
///
/// in the mean of squares (Sibson 1979; Fitzpatrick, West, Maurer 1998), with the 3 N - 6 degrees
/// of freedom of the residuals. It is independent of the error at any target.
///
/// @param fre       RMS residual of the fit
/// @param landmarks their number N, at least 3
[[nodiscard]] LocalisationError localisationError(Length fre, std::size_t landmarks);

/// Combines two independent estimates of the same FLE, such as those of an earlier registration by
/// the same person and of this one: the mean of the squares, weighted by the degrees of freedom,
/// which add up. Where one is known exactly, it is returned.
[[nodiscard]] LocalisationError pooled(const LocalisationError& a, const LocalisationError& b);

} // namespace carina
