#include "engine/registration/error/target_error.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace carina
{
namespace
{

BodyAxis axisNearest(const Vec3& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return static_cast<BodyAxis>(axis);
}

} // namespace

TargetError targetError(const Mat6& covariance_A, const Vec3& p_AQ, double degrees)
{
    TargetError error;
    error.covariance_A = pointCovariance(covariance_A, p_AQ);
    error.rms = metres(std::sqrt(error.covariance_A.trace()));
    error.bound = errorBound(error.covariance_A, degrees);
    error.weakest_A = Eigen::SelfAdjointEigenSolver<Mat3>{error.covariance_A}.eigenvectors().col(2);
    error.weakestAxis = axisNearest(error.weakest_A);
    return error;
}

} // namespace carina
