#pragma once

#include "engine/registration/fit/rigid_fit.h"
#include "engine/registration/fit/uncertain_transform.h"

namespace carina
{

/// One landmark with how uncertain its places are. A touch is uncertain in the manikin's frame
/// (tracker, stylus, hand), a landmark in the anatomy's (how well its edge is told there).
struct UncertainPair {
    LandmarkPair pair;
    Mat3 covariance_A = Mat3::Zero(); ///< of p_AQ, m^2
    Mat3 covariance_M = Mat3::Zero(); ///< of p_MQ, m^2
};

/// A registration that trusts each landmark in each direction as far as its covariance says.
struct WeightedFit {
    RigidFit fit;                     ///< X_AM, and residuals in metres
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM, see UncertainTransform
    /// sum of e^T C^-1 e over the residuals e: about `degrees` where the covariances are true
    double chiSquared = 0.0;
    double degrees = 0.0; ///< of freedom: 3 N - 6

    /// By what all covariances have to be multiplied to agree with the residuals.
    [[nodiscard]] double scale() const { return chiSquared / degrees; }
};

/// The X_AM that minimises
///
///     sum_i e_i^T C_i^-1 e_i       e_i = p_AQ_i - X_AM p_MQ_i     C_i = C_A_i + R_AM C_M_i R_AM^T
///
/// by Gauss and Newton's steps from fitRigid's answer, the C_i turned anew before each and held
/// during it (Ohta and Kanatani 1998; Balachandran and Fitzpatrick 2009). With all C alike in all
/// directions it is fitRigid's.
///
/// @returns what fitRigid returns; NotFinite; OutOfRange where a sum of two covariances is not that
///          of any error; DegenerateLandmarks where the steps do not come to rest, as for
///          touches that contradict each other.
[[nodiscard]] Result<WeightedFit> fitWeighted(std::span<const UncertainPair> pairs);

} // namespace carina
