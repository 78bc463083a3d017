#pragma once

#include "engine/geometry/rigid_transform.h"

#include <Eigen/Eigenvalues>

#include <vector>

namespace carina::test
{

/// The best proper rigid transform from b to a by another way than the engine's: Horn (1987), the
/// eigenvector of the largest eigenvalue of a symmetric 4x4 matrix, which is its quaternion.
inline RigidTransform hornFit(const std::vector<Vec3>& p_A, const std::vector<Vec3>& p_B)
{
    const auto count = static_cast<double>(p_A.size());
    Vec3 mean_A = Vec3::Zero();
    Vec3 mean_B = Vec3::Zero();
    for (std::size_t i = 0; i < p_A.size(); ++i) {
        mean_A += p_A[i] / count;
        mean_B += p_B[i] / count;
    }
    Mat3 s = Mat3::Zero();
    for (std::size_t i = 0; i < p_A.size(); ++i)
        s += (p_B[i] - mean_B) * (p_A[i] - mean_A).transpose();
    Mat4 n;
    n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0), //
        s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),  //
        s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),  //
        s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
    const Eigen::Vector4d q = Eigen::SelfAdjointEigenSolver<Mat4>{n}.eigenvectors().col(3);
    const Quat R_AB{q[0], q[1], q[2], q[3]};
    return {R_AB, mean_A - R_AB * mean_B};
}

} // namespace carina::test
