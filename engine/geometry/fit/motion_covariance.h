#pragma once

#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The covariance of the error of a pose X_FO. The true pose is the given one followed by a small
/// motion (w, v) of the points of F,
///
///     p_FQ_true = p_FQ + w x p_FQ + v        p_FQ = X_FO * p_OQ
///
/// where the rotation vector w (radians) and the shift v (metres) are Gaussian with mean 0; w comes
/// first. To first order in them.
using Mat6 = Eigen::Matrix<double, 6, 6>;

using Vec6 = Eigen::Matrix<double, 6, 1>; ///< a small motion: (w, v)

/// The covariance in F of a point fixed in O, due to the error of the pose X_FO, m^2.
/// @param covariance_F of the pose
/// @param p_FQ         the point in F as given by the pose, metres
[[nodiscard]] Mat3 pointCovariance(const Mat6& covariance_F, const Vec3& p_FQ);

/// The shift w x p + v of a point by a small motion, metres.
[[nodiscard]] Vec3 pointShift(const Vec6& motion_F, const Vec3& p_FQ);

/// Whether a matrix is positive semidefinite up to rounding, as a covariance is.
/// @pre it is symmetric.
[[nodiscard]] bool isCovariance(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The matrix of the cross product: crossMatrix(a) b = a x b.
[[nodiscard]] Mat3 crossMatrix(const Vec3& a);

} // namespace carina
