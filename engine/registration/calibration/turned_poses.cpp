#include "engine/registration/calibration/turned_poses.h"

#include "engine/geometry/fit/point_check.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace carina
{
namespace
{

/// The one of d and -d whose largest component is positive.
Vec3 upright(const Vec3& d)
{
    Eigen::Index largest = 0;
    d.cwiseAbs().maxCoeff(&largest);
    return d[largest] < 0.0 ? Vec3{-d} : d;
}

} // namespace

TurnCoverage PoseMeans::coverage() const
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver{turn}; // ascending
    TurnCoverage coverage;
    for (std::size_t i = 0; i < 3; ++i) {
        coverage.turns[i] =
            radians(std::sqrt(std::max(solver.eigenvalues()[Eigen::Index(i)], 0.0)));
        coverage.dirs_S[i] = upright(solver.eigenvectors().col(Eigen::Index(i)));
    }
    coverage.dir_T_least = (R * coverage.dirs_S[0]).normalized();
    return coverage;
}

Result<std::vector<TurnedPose>> turnedPoses(std::span<const RigidTransform> X_TS)
{
    std::vector<TurnedPose> poses;
    for (const RigidTransform& pose : X_TS) {
        if (const auto sound = checkPoint(pose.translation(), "a pose"); !sound)
            return tl::unexpected(sound.error());
        poses.push_back({pose.rotation().toRotationMatrix(), pose.translation()});
    }
    if (poses.size() < kFewestPoses)
        return fail(Errc::TooFewPoses, std::to_string(poses.size()) + " poses, and "
                                           + std::to_string(kFewestPoses) + " are the fewest");
    return poses;
}

PoseMeans meansOf(std::span<const TurnedPose> poses, std::span<const std::size_t> which)
{
    const double share = 1.0 / double(which.size());
    PoseMeans means;
    for (const std::size_t i : which) {
        means.R += share * poses[i].R_TS;
        means.p += share * poses[i].p_TS;
    }
    for (const std::size_t i : which) {
        const Mat3 off = poses[i].R_TS - means.R;
        means.turn += share * off.transpose() * off;
        means.shift -= share * off.transpose() * (poses[i].p_TS - means.p);
    }
    return means;
}

PoseMeans meansOf(std::span<const TurnedPose> poses)
{
    std::vector<std::size_t> all(poses.size());
    std::iota(all.begin(), all.end(), 0U);
    return meansOf(poses, all);
}

std::string inWords(Angle angle)
{
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.1f degrees", inDegrees(angle));
    return text.data();
}

std::string inWords(Length length)
{
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.2f mm", inMillimetres(length));
    return text.data();
}

std::string inWords(const Vec3& d)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "(%.2f %.2f %.2f)", d.x(), d.y(), d.z());
    return text.data();
}

} // namespace carina
