#pragma once

#include "engine/registration/error/localisation_error.h"
#include "engine/registration/error/target_error.h"
#include "engine/registration/fit/surface_refinement.h"

#include <optional>
#include <span>

namespace carina
{

/// The error of a registration, estimated from its own residuals and those of earlier ones.
struct RegistrationError {
    LocalisationError own;            ///< FLE from its residuals alone, at least RMS(e_i)
    PooledLocalisation touch{};       ///< FLE with the earlier ones
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM: see Mat6 (motion_covariance.h)
};

/// Lower limit of an estimated FLE, and of the error of one touch: the residuals of a few landmarks
/// may be small by chance.
inline constexpr Length kLeastFle = millimetres(0.1);

/// The error of a fit of equal weights (fitRigid): the sum of the independent errors of the
/// touches, estimated from the residuals and pooled with earlier estimates, and of the error of the
/// stylus tip, which all touches share and which does not show in the residuals where the stylus
/// was held alike:
///
///     cov = fitCovariance(FLE_i) + sharedCovariance(tip)
///
/// Where it is known with which error e_i (RMS) the tracker saw the tip at each touch, the FLE is
/// at least their root mean square, and the touches differ by them, as independent errors do that
/// are added to one of the hand:
///
///     FLE_i^2 = FLE^2 + e_i^2 - mean(e^2)
///
/// @param p_AQ  the landmarks of the fit, metres
/// @param R_AS  orientation of the stylus at each landmark
/// @param tip_S covariance of p_SQ, m^2; zero where it is not known
/// @param fre   RMS residual of the fit
/// @param earlier the FLE of earlier registrations by the same person, each from its residuals
/// @param seen  e_i of each touch; nothing where it is not known
/// @pre as many R_AS as landmarks, unless tip_S is zero; as many e_i, or none at all.
/// @returns what fitCovariance returns.
[[nodiscard]] Result<RegistrationError>
registrationError(std::span<const Vec3> p_AQ, std::span<const Mat3> R_AS, const Mat3& tip_S,
                  Length fre, std::span<const LocalisationError> earlier = {},
                  std::span<const std::optional<Length>> seen = {});

/// The covariance of a registration by landmarks after its refinement on a surface: that of the
/// swab for the motions that the swab constrains, and that of the landmarks for the loose ones.
/// With c the swab's centre and P the projection onto the loose motions, rotations scaled by the
/// swab's extent,
///
///     cov = T (cov_swab + P cov_before P^T + (I - P) cov_tip (I - P)^T) T^T
///
/// where T converts motions about c to motions about the origin of A, and cov_before is taken about
/// c. The tip's error shifts the whole swab. Since a swab does not store the orientation of the
/// stylus, cov_tip is that of an isotropic shift with the largest variance of tip_S.
/// @param before_A covariance of X_AM before the refinement, see Mat6 (motion_covariance.h)
/// @param tip_S    covariance of p_SQ, m^2; zero where it is not known
[[nodiscard]] Mat6 refinedCovariance(const Mat6& before_A, const SurfaceRefinement& refinement,
                                     const Mat3& tip_S = Mat3::Zero());

} // namespace carina
