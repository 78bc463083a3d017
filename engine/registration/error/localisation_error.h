#pragma once

#include "engine/core/units.h"
#include "engine/registration/error/error_bound.h"

#include <cstddef>
#include <span>

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
/// An error that all touches share cannot be estimated so. Where the surface of the model lies
/// inside or outside that of the real manikin, each touch is off by that distance in a similar way,
/// and the fit takes the common part up: it leaves no residual, but displaces every target. The
/// same holds for a wrong tip of the stylus (sharedCovariance) and for skin that always gives way
/// alike. Only points that were not used in the fit can show it, and only where they do not share
/// the error.
///
/// @param fre       RMS residual of the fit
/// @param landmarks their number N, at least 3
[[nodiscard]] LocalisationError localisationError(Length fre, std::size_t landmarks);

/// The FLE of a registration and of earlier ones by the same person.
struct PooledLocalisation {
    LocalisationError fle; ///< from all that agree
    int pooled = 0;        ///< how many earlier estimates are in it
    int disagreeing = 0;   ///< how many are not
};

/// An earlier estimate disagrees where the ratio of the variances is as far from 1, to either side,
/// as one of kDisagreeShare of the ratios of equal errors (F test).
inline constexpr double kDisagreeShare = 0.01;

/// Combines independent estimates of the same FLE: the mean of the squares, weighted by the degrees
/// of freedom, which add up. Earlier estimates that disagree with that of this registration are
/// left out. None of them depends on the error of this registration at a target.
///
/// Registrations of one manikin share the errors of its model: the distance of each landmark in the
/// model from its place on the real manikin is the same every time. Of this distance, what leaves
/// residuals is counted as if it were drawn anew each time, so that the pooled estimate has fewer
/// independent degrees of freedom than stated, and its limit is too low where the model's part is
/// large. What leaves none is in no estimate (localisationError).
/// @pre all are estimates: their degrees of freedom are finite, their rms above 0.
[[nodiscard]] PooledLocalisation pooled(const LocalisationError& now,
                                        std::span<const LocalisationError> earlier);

} // namespace carina
