#include "engine/registration/fit/uncertain_transform.h"

#include <Eigen/Eigenvalues>

namespace carina
{
namespace
{

constexpr double kLeastVariance = -1e-9; ///< as a share of the largest

/// Takes (w, v) of O's points to that of F's.
Mat6 adjointOf(const RigidTransform& X_FO)
{
    const Mat3 R_FO = X_FO.rotation().toRotationMatrix();
    Mat6 adjoint = Mat6::Zero();
    adjoint.topLeftCorner<3, 3>() = R_FO;
    adjoint.bottomLeftCorner<3, 3>() = crossMatrix(X_FO.translation()) * R_FO;
    adjoint.bottomRightCorner<3, 3>() = R_FO;
    return adjoint;
}

} // namespace

bool isCovariance(const Eigen::Ref<const Eigen::MatrixXd>& matrix)
{
    const Eigen::VectorXd variances =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{matrix, Eigen::EigenvaluesOnly}
            .eigenvalues();
    return variances.minCoeff() >= kLeastVariance * variances.cwiseAbs().maxCoeff();
}

Mat3 crossMatrix(const Vec3& a)
{
    Mat3 matrix;
    matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return matrix;
}

UncertainTransform operator*(const UncertainTransform& X_FO, const UncertainTransform& X_OQ)
{
    const Mat6 adjoint = adjointOf(X_FO.X_FO);
    return {X_FO.X_FO * X_OQ.X_FO,
            X_FO.covariance_F + adjoint * X_OQ.covariance_F * adjoint.transpose()};
}

UncertainTransform inverse(const UncertainTransform& X_FO)
{
    const RigidTransform X_OF = X_FO.X_FO.inverse();
    const Mat6 adjoint = adjointOf(X_OF);
    return {X_OF, adjoint * X_FO.covariance_F * adjoint.transpose()};
}

Mat3 pointCovariance(const Mat6& covariance_F, const Vec3& p_FQ)
{
    Eigen::Matrix<double, 3, 6> moved; // w x p + v
    moved << -crossMatrix(p_FQ), Mat3::Identity();
    return moved * covariance_F * moved.transpose();
}

Mat3 pointCovariance(const UncertainTransform& X_FO, const Vec3& p_OQ, const Mat3& covariance_O)
{
    const Mat3 R_FO = X_FO.X_FO.rotation().toRotationMatrix();
    return pointCovariance(X_FO.covariance_F, X_FO.X_FO * p_OQ)
           + R_FO * covariance_O * R_FO.transpose();
}

} // namespace carina
