#pragma once

#include "engine/core/result.h"
#include "engine/registration/error/error_bound.h"
#include "engine/registration/error/localisation_error.h"
#include "engine/registration/fit/uncertain_transform.h"

#include <cstdint>
#include <span>
#include <vector>

namespace carina
{

/// A landmark Q and how far one touch of it strays, with what is uncertain of its place in the
/// anatomy.
struct LandmarkError {
    Vec3 p_AQ = Vec3::Zero();         ///< metres
    Mat3 covariance_A = Mat3::Zero(); ///< m^2; positive definite
};

/// Landmarks that stray alike in all directions.
/// @param fle root of the expected squared length
[[nodiscard]] std::vector<LandmarkError> equalErrors(std::span<const Vec3> p_AQ, Length fle);

/// By what a fit weighs the landmarks: all alike (fitRigid), or each by the inverse of its
/// covariance (fitWeighted).
enum class Weighting : std::uint8_t { Alike, ByCovariance };

/// The covariance of X_AM as UncertainTransform has it, before anything is touched: to first order
/// a fit moves by
///
///     (w, v) = S^-1 sum_i J_i^T W_i e_i        S = sum_i J_i^T W_i J_i
///
/// for errors e_i at the landmarks, with J (w, v) = w x p + v and the weights W. Of landmarks that
/// stray independently that gives S^-1 (sum_i J_i^T W_i C_i W_i J_i) S^-1 (Danilchenko and
/// Fitzpatrick 2011), which is S^-1 for weights C_i^-1 (Wiles et al. 2008), and for equal errors
/// the formula of Fitzpatrick, West and Maurer (1998).
///
/// @returns TooFewLandmarks below three; DegenerateLandmarks as fitRigid; NotFinite; OutOfRange for
///          a place a kilometre away or a covariance that is none.
[[nodiscard]] Result<Mat6> fitCovariance(std::span<const LandmarkError> landmarks,
                                         Weighting weighting = Weighting::Alike);

/// The same of an error that all touches share, as that of the stylus's tip: known in S with a
/// covariance, it reaches each landmark turned as the stylus was held. Add it to fitCovariance's.
///
/// @param R_AS how the stylus was held at each landmark
/// @pre as many as there are landmarks.
[[nodiscard]] Result<Mat6> sharedCovariance(std::span<const LandmarkError> landmarks,
                                            std::span<const Mat3> R_AS, const Mat3& covariance_S,
                                            Weighting weighting = Weighting::Alike);

/// The axes of the anatomy frame, as directions of the body.
enum class BodyAxis : std::uint8_t { LeftRight, FrontBack, HeadFeet };

/// The target registration error (TRE): how far the anatomy is drawn from its place at a target.
struct TargetError {
    Mat3 covariance_A = Mat3::Zero();           ///< m^2
    Length rms;                                 ///< root of the expected squared length
    Length bound;                               ///< of 95 %: errorBound
    Vec3 weakest_A = Vec3::UnitX();             ///< unit: the direction in which it is largest
    BodyAxis weakestAxis = BodyAxis::LeftRight; ///< nearest to that
};

/// @param degrees of freedom of what fixed the size of the landmarks' errors: that of the
///        LocalisationError for errors estimated from residuals, so that the bound holds in 95 % of
///        registrations although the size is not known; kKnownExactly where a tracker's figures are
///        taken for true
[[nodiscard]] TargetError targetError(const Mat6& covariance_A, const Vec3& p_AQ,
                                      double degrees = kKnownExactly);

} // namespace carina
