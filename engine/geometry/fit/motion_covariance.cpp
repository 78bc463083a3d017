#include "engine/geometry/fit/motion_covariance.h"

#include <Eigen/Eigenvalues>

namespace carina
{
namespace
{

constexpr double kLeastVariance = -1e-9; ///< as a share of the largest

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

Vec3 pointShift(const Vec6& motion_F, const Vec3& p_FQ)
{
    return motion_F.head<3>().cross(p_FQ) + motion_F.tail<3>();
}

Mat3 pointCovariance(const Mat6& covariance_F, const Vec3& p_FQ)
{
    Eigen::Matrix<double, 3, 6> moved; // w x p + v
    moved << -crossMatrix(p_FQ), Mat3::Identity();
    return moved * covariance_F * moved.transpose();
}

} // namespace carina
