#pragma once

#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/rigid_transform.h"

#include <Eigen/Cholesky>

#include <array>
#include <vector>

namespace carina::test
{

/// A camera by the formula of Brown (1966), as OpenCV documents it (k1, k2, p1, p2, k3), written
/// down here anew: at the origin of T, +x right, +y up, looking along -z.
struct PinholeCamera {
    Eigen::Vector2d focal;
    Eigen::Vector2d centre;
    std::array<double, 5> k{};

    [[nodiscard]] Eigen::Vector2d pixel(const Vec3& p_T) const
    {
        const double x = p_T.x() / -p_T.z();
        const double y = -p_T.y() / -p_T.z();
        const double r2 = x * x + y * y;
        const double radial = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
        return {
            focal.x() * (x * radial + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x)) + centre.x(),
            focal.y() * (y * radial + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y) + centre.y()};
    }
};

/// A corner of a body, and where it was seen.
struct CornerAt {
    Vec3 p_BQ;
    Eigen::Vector2d pixel;
};

/// The error of the pose that fits the corners best, to first order in what they are off by, e:
/// (J^T J)^-1 J^T e, where J is how the pixels move with the pose.
/// @param X_TB the true pose
/// @returns the turn (rad) and the shift of the origin of B (m), in axes of T
inline Vec6 propagatedError(const PinholeCamera& camera, const RigidTransform& X_TB,
                            const std::vector<CornerAt>& corners)
{
    constexpr double kStep = 1e-6; // metres
    Mat6 information = Mat6::Zero();
    Vec6 pull = Vec6::Zero();
    for (const CornerAt& corner : corners) {
        const Vec3 p_TQ = X_TB * corner.p_BQ;
        Eigen::Matrix<double, 2, 3> slope;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = kStep * Vec3::Unit(axis);
            slope.col(axis) =
                (camera.pixel(p_TQ + step) - camera.pixel(p_TQ - step)) / (2.0 * kStep);
        }
        Eigen::Matrix<double, 2, 6> J;
        J << -slope * crossMatrix(p_TQ - X_TB.translation()), slope;
        information += J.transpose() * J;
        pull += J.transpose() * (corner.pixel - camera.pixel(p_TQ));
    }
    return information.ldlt().solve(pull);
}

} // namespace carina::test
