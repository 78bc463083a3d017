#pragma once

#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The covariance of a small motion (w, v), see UncertainTransform.
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The pose of O in F with its covariance. The true pose is the given one followed by a small
/// motion (w, v) of the points of F,
///
///     p_FQ_true = p_FQ + w x p_FQ + v        p_FQ = X_FO * p_OQ
///
/// where the rotation vector w (radians) and the shift v (metres) are Gaussian with mean 0. All
/// functions are first order in them and assume that the errors of different poses are independent.
struct UncertainTransform {
    RigidTransform X_FO;
    Mat6 covariance_F = Mat6::Zero(); ///< of (w, v)
};

/// The product X_FQ = X_FO * X_OQ. With Ad the adjoint matrix of X_FO, which converts small motions
/// from O to F, cov = cov_FO + Ad cov_OQ Ad^T.
[[nodiscard]] UncertainTransform operator*(const UncertainTransform& X_FO,
                                           const UncertainTransform& X_OQ);

/// The inverse X_OF.
[[nodiscard]] UncertainTransform inverse(const UncertainTransform& X_FO);

/// The covariance in F of a point fixed in O, due to the error of the pose X_FO, m^2.
/// @param p_FQ the point in F as given by the pose, metres
[[nodiscard]] Mat3 pointCovariance(const Mat6& covariance_F, const Vec3& p_FQ);

/// The same for a point whose position in O has a covariance, too.
[[nodiscard]] Mat3 pointCovariance(const UncertainTransform& X_FO, const Vec3& p_OQ,
                                   const Mat3& covariance_O);

/// Whether a matrix is positive semidefinite up to rounding, as a covariance is.
/// @pre it is symmetric.
[[nodiscard]] bool isCovariance(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The matrix of the cross product: crossMatrix(a) b = a x b.
[[nodiscard]] Mat3 crossMatrix(const Vec3& a);

} // namespace carina
