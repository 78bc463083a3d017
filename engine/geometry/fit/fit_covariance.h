#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/fit/motion_covariance.h"

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

/// The motion (w, v) of a fit, see Mat6, by errors that are the same every time, such as those of
/// markers that are seen through a tilted glass: S^-1 sum_i J_i^T W_i b_i as above. Its mean
/// squared error at a point is the trace of pointCovariance plus the square of pointShift.
///
/// @param biases_A b of each landmark, metres
/// @pre as many biases as landmarks.
/// @returns what fitCovariance returns.
[[nodiscard]] Result<Vec6> fitBias(std::span<const LandmarkError> landmarks,
                                   std::span<const Vec3> biases_A,
                                   Weighting weighting = Weighting::Alike);

} // namespace carina
