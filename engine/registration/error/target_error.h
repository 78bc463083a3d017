#pragma once

#include "engine/core/result.h"
#include "engine/registration/error/error_bound.h"
#include "engine/registration/error/localisation_error.h"
#include "engine/registration/fit/motion_covariance.h"

#include <cstdint>
#include <span>
#include <vector>

namespace carina
{

/// A landmark Q and the covariance of one touch of it, including the uncertainty of its place in
/// the anatomy.
struct LandmarkError {
    Vec3 p_AQ = Vec3::Zero();         ///< metres
    Mat3 covariance_A = Mat3::Zero(); ///< m^2; positive definite
};

/// Landmarks with the same isotropic error: covariance FLE^2 / 3 times the identity.
/// @param fle root mean square length of the error
[[nodiscard]] std::vector<LandmarkError> equalErrors(std::span<const Vec3> p_AQ, Length fle);

/// The weights of the landmarks in a fit: all equal (fitRigid), or the inverse covariance of each
/// (fitWeighted).
enum class Weighting : std::uint8_t { Alike, ByCovariance };

/// The predicted covariance of X_AM (see Mat6), without any touches: to first order
/// errors e_i at the landmarks move a fit by
///
///     (w, v) = S^-1 sum_i J_i^T W_i e_i        S = sum_i J_i^T W_i J_i
///
/// with J_i (w, v) = w x p_i + v and the weights W_i. For independent errors the covariance is S^-1
/// (sum_i J_i^T W_i C_i W_i J_i) S^-1 (Danilchenko and Fitzpatrick 2011); this is S^-1 for the
/// weights C_i^-1 (Wiles et al. 2008), and for equal errors the formula of Fitzpatrick, West and
/// Maurer (1998).
///
/// @returns TooFewLandmarks below three; DegenerateLandmarks as fitRigid; NotFinite; OutOfRange for
///          a landmark a kilometre or more away, or for a matrix that is not a positive definite
///          covariance.
[[nodiscard]] Result<Mat6> fitCovariance(std::span<const LandmarkError> landmarks,
                                         Weighting weighting = Weighting::Alike);

/// The contribution of an error that all touches share, such as that of the stylus tip: it is
/// constant in S and acts at each landmark in the orientation of the stylus there. To be added to
/// fitCovariance.
///
/// @param R_AS         orientation of the stylus at each landmark
/// @param covariance_S covariance of the shared error, m^2, in S
/// @pre as many R_AS as landmarks.
/// @returns what fitCovariance returns.
[[nodiscard]] Result<Mat6> sharedCovariance(std::span<const LandmarkError> landmarks,
                                            std::span<const Mat3> R_AS, const Mat3& covariance_S,
                                            Weighting weighting = Weighting::Alike);

/// The axes of the anatomy frame, as directions of the body.
enum class BodyAxis : std::uint8_t { LeftRight, FrontBack, HeadFeet };

/// The target registration error (TRE): the distance at a target between the drawn anatomy and its
/// true place.
struct TargetError {
    Mat3 covariance_A = Mat3::Zero();           ///< m^2
    Length rms;                                 ///< root mean square length of the error
    Length bound;                               ///< 95 % bound (errorBound)
    Vec3 weakest_A = Vec3::UnitX();             ///< unit: the direction of the largest variance
    BodyAxis weakestAxis = BodyAxis::LeftRight; ///< the axis nearest to weakest_A
};

/// The TRE at a target.
/// @param covariance_A of X_AM, see Mat6 (motion_covariance.h)
/// @param p_AQ the target, metres
/// @param degrees degrees of freedom of the FLE that covariance_A is based on: those of the
///                LocalisationError where it was estimated from residuals, so that the bound holds
///                in 95 % of registrations; kKnownExactly where it is taken as known
[[nodiscard]] TargetError targetError(const Mat6& covariance_A, const Vec3& p_AQ,
                                      double degrees = kKnownExactly);

} // namespace carina
