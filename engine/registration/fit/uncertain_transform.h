#pragma once

#include "engine/geometry/rigid_transform.h"

namespace carina
{

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The pose of O in F and how far it may be off: the true pose is a small motion (w, v) of F's
/// points after it,
///
///     p_FQ_true = p_FQ + w x p_FQ + v        p_FQ = X_FO * p_OQ
///
/// where the turn w (radians) and the shift v (metres) are Gaussian with mean 0. Everything here is
/// first order in them; for independent poses only.
struct UncertainTransform {
    RigidTransform X_FO;
    Mat6 covariance_F = Mat6::Zero(); ///< of (w, v)
};

/// X_FQ of X_FO and X_OQ. With Ad taking small motions of O's points to F,
/// cov = cov_FO + Ad cov_OQ Ad^T.
[[nodiscard]] UncertainTransform operator*(const UncertainTransform& X_FO,
                                           const UncertainTransform& X_OQ);

/// X_OF of X_FO.
[[nodiscard]] UncertainTransform inverse(const UncertainTransform& X_FO);

/// How far a point that lies fixed in O is off in F for the pose's error, m^2.
/// @param p_FQ where the pose says that it is, in F
[[nodiscard]] Mat3 pointCovariance(const Mat6& covariance_F, const Vec3& p_FQ);

/// The same for a point that is itself known with an error in O.
[[nodiscard]] Mat3 pointCovariance(const UncertainTransform& X_FO, const Vec3& p_OQ,
                                   const Mat3& covariance_O);

/// Whether errors can have such a covariance: no variance is negative, but for rounding.
/// @pre it is symmetric.
[[nodiscard]] bool isCovariance(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The matrix of the cross product: crossMatrix(a) b = a x b.
[[nodiscard]] Mat3 crossMatrix(const Vec3& a);

} // namespace carina
