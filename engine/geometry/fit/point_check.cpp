#include "engine/geometry/fit/point_check.h"

#include "engine/geometry/fit/rigid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace carina
{
Result<void> checkPoint(const Vec3& p, const char* what)
{
    if (!p.allFinite())
        return fail(Errc::NotFinite, std::string{what} + " has a coordinate that is no number");
    if (p.cwiseAbs().maxCoeff() >= kFarthest.si)
        return fail(Errc::OutOfRange, std::string{what} + " is a kilometre away or more");
    return {};
}

Result<void> checkSpread(const Mat3& scatter, const char* whose)
{
    const Vec3 squares = // of extents, ascending
        Eigen::SelfAdjointEigenSolver<Mat3>{scatter, Eigen::EigenvaluesOnly}.eigenvalues();
    if (squares[2] < kSmallestExtent.si * kSmallestExtent.si)
        return fail(Errc::DegenerateLandmarks, std::string{whose} + " landmarks lie at one place");
    if (squares[1] < kCollinearShare * kCollinearShare * squares[2])
        return fail(Errc::DegenerateLandmarks, std::string{whose} + " landmarks lie on one line");
    return {};
}

Result<void> checkCovariance(const Mat3& covariance)
{
    if (!covariance.allFinite())
        return fail(Errc::NotFinite, "a landmark's covariance has an entry that is no number");
    constexpr double kRounding = 1e-9;
    const double size = covariance.norm();
    if ((covariance - covariance.transpose()).norm() > kRounding * size
        || covariance.llt().info() != Eigen::Success)
        return fail(Errc::OutOfRange, "a landmark's covariance is not that of any error");
    return {};
}

} // namespace carina
