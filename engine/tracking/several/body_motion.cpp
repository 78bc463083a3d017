#include "engine/tracking/several/body_motion.h"

#include "engine/geometry/rotation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Of Markley and others (2007): signs of the quaternions do not count.
Quat meanRotation(std::span<const RigidTransform> poses)
{
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (const RigidTransform& X_FO : poses)
        sum += X_FO.rotation().coeffs() * X_FO.rotation().coeffs().transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes{sum}; // ascending
    return Quat{Eigen::Vector4d{axes.eigenvectors().col(3)}};
}

std::array<Angle, 3> turnsOf(std::span<const RigidTransform> poses)
{
    const Quat mean = meanRotation(poses);
    Mat3 spread = Mat3::Zero();
    for (const RigidTransform& X_FO : poses) {
        const Vec3 turn = rotationVector(mean.conjugate() * X_FO.rotation());
        spread += turn * turn.transpose();
    }
    // Ascending.
    const Eigen::SelfAdjointEigenSolver<Mat3> axes{spread / double(poses.size())};
    const auto rms = [&](int axis) {
        return radians(std::sqrt(std::max(axes.eigenvalues()[axis], 0.0)));
    };
    return {rms(2), rms(1), rms(0)};
}

} // namespace

BodyMotion bodyMotion(std::span<const RigidTransform> poses)
{
    if (poses.empty())
        return {};
    Vec3 least = poses.front().translation();
    Vec3 most = least;
    for (const RigidTransform& X_FO : poses) {
        least = least.cwiseMin(X_FO.translation());
        most = most.cwiseMax(X_FO.translation());
    }
    return {turnsOf(poses), metres((most - least).maxCoeff())};
}

std::vector<RigidTransform> seenPoses(std::span<const PoseSample> samples)
{
    std::vector<RigidTransform> poses;
    for (const PoseSample& sample : samples)
        if (sample.validity != Validity::Lost)
            poses.push_back(sample.X_FO);
    return poses;
}

} // namespace carina
