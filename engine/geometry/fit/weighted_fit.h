#pragma once

#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/fit/rigid_fit.h"

namespace carina
{

/// One landmark with the covariances of its positions: of the touch in the manikin's frame
/// (tracker, stylus, hand), and of the landmark in the anatomy's (how exactly it is defined there).
struct UncertainPair {
    LandmarkPair pair;
    Mat3 covariance_A = Mat3::Zero(); ///< of p_AQ, m^2
    Mat3 covariance_M = Mat3::Zero(); ///< of p_MQ, m^2
};

/// A registration that weights each landmark by the inverse of its covariance.
struct WeightedFit {
    RigidFit fit;                     ///< X_AM, and residuals in metres
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM, see Mat6 (motion_covariance.h)
    /// sum of e^T C^-1 e over the residuals e: about `degrees` where the covariances are correct
    double chiSquared = 0.0;
    double degrees = 0.0; ///< degrees of freedom: 3 N - 6

    /// The factor by which all covariances must be multiplied to agree with the residuals.
    [[nodiscard]] double scale() const { return chiSquared / degrees; }
};

/// The X_AM that minimises
///
///     sum_i e_i^T C_i^-1 e_i       e_i = p_AQ_i - X_AM p_MQ_i     C_i = C_A_i + R_AM C_M_i R_AM^T
///
/// by Gauss-Newton steps from the result of fitRigid; the C_i are computed with the current
/// rotation before each step and constant during it (Ohta and Kanatani 1998; Balachandran and
/// Fitzpatrick 2009). With equal isotropic C_i the result is that of fitRigid.
///
/// @returns the errors of fitRigid; NotFinite; OutOfRange where the sum of both covariances of a
///          landmark is not symmetric and positive definite; DegenerateLandmarks where the steps do
///          not converge, as for touches that contradict each other.
[[nodiscard]] Result<WeightedFit> fitWeighted(std::span<const UncertainPair> pairs);

} // namespace carina
