#include "engine/vision/body_pose.h"

#include "engine/geometry/rotation.h"
#include "engine/vision/pose_candidates.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

using Vec6 = Eigen::Matrix<double, 6, 1>;

constexpr int kSteps = 30;
constexpr double kSmallStep = 1e-10; ///< radians, and shares of the distance
constexpr double kPriorDegrees = 4.0;
constexpr double kOpenMotion = 1e-13;
constexpr Angle kSamePose = degrees(0.5);

/// The normal equations of a small motion (w, v) about the body's origin.
struct Normal {
    Mat6 matrix = Mat6::Zero();
    Vec6 right = Vec6::Zero();
    double squares = 0.0;
};

std::optional<Normal> normalAt(const CameraModel& camera, std::span<const SeenCorner> corners,
                               const RigidTransform& X_TB)
{
    Normal normal;
    for (const SeenCorner& corner : corners) {
        const Vec3 turned = X_TB.rotation() * corner.p_BQ;
        const Vec3 p_TQ = turned + X_TB.translation();
        const auto pixel = project(camera, p_TQ);
        if (!pixel)
            return std::nullopt;
        const Vec2 missing = corner.pixel - *pixel;
        Eigen::Matrix<double, 3, 6> motion;
        motion << -crossMatrix(turned), Mat3::Identity();
        const Eigen::Matrix<double, 2, 6> slope = projectionSlope(camera, p_TQ) * motion;
        normal.matrix += slope.transpose() * slope;
        normal.right += slope.transpose() * missing;
        normal.squares += missing.squaredNorm();
    }
    return normal;
}

RigidTransform moved(const RigidTransform& X_TB, const Vec6& step)
{
    return {rotationFromVector(step.head<3>()) * X_TB.rotation(),
            X_TB.translation() + step.tail<3>()};
}

double squaresAt(const CameraModel& camera, std::span<const SeenCorner> corners,
                 const RigidTransform& X_TB)
{
    double sum = 0.0;
    for (const SeenCorner& corner : corners) {
        const auto pixel = project(camera, X_TB * corner.p_BQ);
        if (!pixel)
            return std::numeric_limits<double>::infinity();
        sum += (corner.pixel - *pixel).squaredNorm();
    }
    return sum;
}

/// The covariance of the least squares, whose motion is about the body's origin, as one of points
/// of T: v of that motion is v + p x w.
Mat6 covarianceOf(const Normal& normal, const RigidTransform& X_TB, std::size_t corners)
{
    const double degreesOfFreedom = std::max(2.0 * double(corners) - 6.0, 0.0);
    const double variance = (kPriorDegrees * kCornerNoise * kCornerNoise + normal.squares)
                            / (kPriorDegrees + degreesOfFreedom);
    const Mat6 aboutBody = variance * normal.matrix.ldlt().solve(Mat6::Identity());
    Mat6 toOrigin = Mat6::Identity();
    toOrigin.bottomLeftCorner<3, 3>() = crossMatrix(X_TB.translation());
    const Mat6 covariance = toOrigin * aboutBody * toOrigin.transpose();
    return 0.5 * (covariance + covariance.transpose());
}

/// Whether the corners leave no motion open.
bool determines(const Normal& normal)
{
    const Vec6 pivots = normal.matrix.ldlt().vectorD();
    return pivots.minCoeff() > kOpenMotion * pivots.maxCoeff();
}

std::optional<FittedBody> refined(const CameraModel& camera, std::span<const SeenCorner> corners,
                                  RigidTransform X_TB)
{
    double damping = 1e-4;
    auto normal = normalAt(camera, corners, X_TB);
    for (int i = 0; normal && i < kSteps; ++i) {
        Mat6 damped = normal->matrix;
        damped.diagonal() *= 1.0 + damping;
        const Vec6 step = damped.ldlt().solve(normal->right);
        if (!step.allFinite())
            return std::nullopt;
        const RigidTransform next = moved(X_TB, step);
        if (squaresAt(camera, corners, next) <= normal->squares) {
            X_TB = next;
            damping = std::max(0.1 * damping, 1e-12);
            normal = normalAt(camera, corners, X_TB);
        } else {
            damping *= 10.0;
        }
        if (step.norm() < kSmallStep || damping > 1e12)
            break;
    }
    if (!normal || !determines(*normal))
        return std::nullopt;
    FittedBody fitted{.X_TB = X_TB,
                      .rms = std::sqrt(normal->squares / double(corners.size())),
                      .squares = normal->squares,
                      .covariance_T = covarianceOf(*normal, X_TB, corners.size())};
    if (!fitted.covariance_T.allFinite())
        return std::nullopt;
    return fitted;
}

} // namespace

std::optional<BodyFit> fitBody(const CameraModel& camera, std::span<const SeenCorner> corners)
{
    if (corners.size() < 4)
        return std::nullopt;
    std::vector<FittedBody> minima;
    for (const RigidTransform& candidate : poseCandidates(camera, corners))
        if (auto fitted = refined(camera, corners, candidate))
            minima.push_back(*fitted);
    if (minima.empty())
        return std::nullopt;
    std::ranges::sort(minima, {}, &FittedBody::squares);
    BodyFit fit{.best = minima.front()};
    const auto rival = std::ranges::find_if(minima, [&](const FittedBody& other) {
        return angleBetween(other.X_TB.rotation(), fit.best.X_TB.rotation()) > kSamePose;
    });
    if (rival == minima.end())
        return fit;
    fit.rival = *rival;
    const double degreesOfFreedom = 2.0 * double(corners.size()) - 6.0;
    const double variance = (kPriorDegrees * kCornerNoise * kCornerNoise + fit.best.squares)
                            / (kPriorDegrees + degreesOfFreedom);
    fit.evidence = 0.5 * (rival->squares - fit.best.squares) / variance;
    return fit;
}

} // namespace carina
