#pragma once

#include "engine/registration/error/localisation_error.h"
#include "engine/registration/error/target_error.h"
#include "engine/registration/fit/surface_refinement.h"

#include <span>

namespace carina
{

/// What a registration that was just made tells of its own error.
struct RegistrationError {
    LocalisationError fle;            ///< from its residuals
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM: see UncertainTransform
};

/// No hand touches better than this, however small the residuals of a few landmarks happen to be.
inline constexpr Length kLeastFle = millimetres(0.1);

/// The error of a fit of equal weights (fitRigid): what its residuals tell of the touches, which
/// stray independently, and of the stylus's tip, whose error all touches share and no residual
/// shows where the stylus was held alike:
///
///     cov = fitCovariance(FLE of the residuals) + sharedCovariance(tip)
///
/// @param p_AQ         the landmarks of the fit
/// @param R_AS         how the stylus was held at each
/// @param tip_S        covariance of p_SQ, m^2; zero where it is not known
/// @param fre          rms of the fit
/// @pre as many R_AS as there are landmarks.
/// @returns what fitCovariance returns.
[[nodiscard]] Result<RegistrationError> registrationError(std::span<const Vec3> p_AQ,
                                                          std::span<const Mat3> R_AS,
                                                          const Mat3& tip_S, Length fre);

/// The covariance of a registration by landmarks after it was refined on a surface: the motions
/// that the swab holds are as uncertain as the swab says, the loose ones as they were. With c the
/// swab's centre and P the projection on the loose motions, turns scaled by the swab's extent,
///
///     cov = T (cov_swab + P cov_before P^T + (I - P) cov_tip (I - P)^T) T^T
///
/// with T taking motions about c to motions about A's origin. All of a swab shares the tip's error,
/// which shifts it; cov_tip is that of a shift, in every direction as large as the tip's error is
/// in its largest, for a swab does not keep how the stylus was held.
/// @param tip_S covariance of p_SQ, m^2; zero where it is not known
[[nodiscard]] Mat6 refinedCovariance(const Mat6& before_A, const SurfaceRefinement& refinement,
                                     const Mat3& tip_S = Mat3::Zero());

} // namespace carina
