#include "engine/registration/pivot_calibration.h"

#include "engine/registration/point_check.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina
{
namespace
{

constexpr std::size_t kFewestPoses = 10;

/// A pose with how far the tip would be from the divot in it.
struct Turned {
    Mat3 R_TS;
    Vec3 p_TS;
    double distance = 0.0;
};

struct Pivot {
    Vec3 p_SQ;
    Vec3 p_TQ;
    double leastTurn; ///< RMS, radians while small, of the direction that turned least
    double mostTurn;
};

/// With R and p the means of R_TS and p_TS, the best divot of a tip is R p_SQ + p. That leaves
///
///     sum (R_TS - R)^T (R_TS - R) p_SQ = - sum (R_TS - R)^T p_TS
///
/// where the quadratic form of the left side over their number is how much a direction of the
/// stylus turned, as the mean square of the way of its unit vector.
Pivot solve(std::span<const Turned> poses)
{
    const double share = 1.0 / double(poses.size());
    Mat3 R = Mat3::Zero();
    Vec3 p = Vec3::Zero();
    for (const Turned& pose : poses) {
        R += share * pose.R_TS;
        p += share * pose.p_TS;
    }
    Mat3 turn = Mat3::Zero();
    Vec3 shift = Vec3::Zero();
    for (const Turned& pose : poses) {
        const Mat3 off = pose.R_TS - R;
        turn += share * off.transpose() * off;
        shift -= share * off.transpose() * pose.p_TS;
    }
    const Vec3 squares = // ascending
        Eigen::SelfAdjointEigenSolver<Mat3>{turn, Eigen::EigenvaluesOnly}.eigenvalues();
    const Vec3 p_SQ = turn.ldlt().solve(shift);
    return {p_SQ, R * p_SQ + p, std::sqrt(std::max(squares[0], 0.0)), std::sqrt(squares[2])};
}

Result<std::vector<Turned>> turnedOf(std::span<const RigidTransform> X_TS)
{
    std::vector<Turned> poses;
    for (const RigidTransform& pose : X_TS) {
        if (const auto sound = checkPoint(pose.translation(), "a pose of the stylus"); !sound)
            return tl::unexpected(sound.error());
        poses.push_back({pose.rotation().toRotationMatrix(), pose.translation()});
    }
    if (poses.size() < kFewestPoses)
        return fail(Errc::TooFewPoses, std::to_string(poses.size()) + " poses, and "
                                           + std::to_string(kFewestPoses) + " are the fewest");
    return poses;
}

Result<Pivot> pivotOf(std::span<const Turned> poses, Angle leastTurn)
{
    const Pivot pivot = solve(poses);
    if (pivot.mostTurn < leastTurn.si)
        return fail(Errc::NotEnoughMotion, "the stylus was hardly turned");
    if (pivot.leastTurn < leastTurn.si)
        return fail(Errc::NotEnoughMotion, "the stylus was turned about one axis only");
    return pivot;
}

double distanceTo(const Pivot& pivot, const Turned& pose)
{
    return (pose.R_TS * pivot.p_SQ + pose.p_TS - pivot.p_TQ).norm();
}

/// Sorts poses by their distance. @returns how many are within the limit.
std::size_t sortByDistance(std::vector<Turned>& poses, const Pivot& pivot, double limit)
{
    for (Turned& pose : poses)
        pose.distance = distanceTo(pivot, pose);
    std::ranges::sort(poses, {}, &Turned::distance);
    const auto firstTooFar = std::ranges::upper_bound(poses, limit, {}, &Turned::distance);
    return static_cast<std::size_t>(firstTooFar - poses.begin());
}

} // namespace

Result<PivotCalibration> calibratePivot(std::span<const RigidTransform> X_TS,
                                        const PivotSettings& settings)
{
    auto poses = turnedOf(X_TS);
    if (!poses)
        return tl::unexpected(poses.error());
    const double limit = settings.outlierLimit.si;
    const std::size_t fewest = std::max(kFewestPoses, (poses->size() + 1) / 2);
    std::size_t kept = poses->size();
    auto pivot = pivotOf(*poses, settings.leastTurn);
    while (pivot) {
        const std::size_t agreeing = sortByDistance(*poses, *pivot, limit);
        const bool settled = agreeing >= kept;
        kept = settled ? agreeing : kept - (kept - agreeing + 9) / 10;
        if (kept < fewest)
            return fail(Errc::TooFewPoses, "fewer than half of the poses, or fewer than "
                                               + std::to_string(kFewestPoses) + ", agree");
        pivot = pivotOf(std::span{*poses}.first(kept), settings.leastTurn);
        if (settled)
            break;
    }
    if (!pivot)
        return tl::unexpected(pivot.error());

    double squares = 0.0;
    for (const Turned& pose : std::span{*poses}.first(kept))
        squares += std::pow(distanceTo(*pivot, pose), 2);
    return PivotCalibration{.p_SQ = pivot->p_SQ,
                            .p_TQ = pivot->p_TQ,
                            .rms = std::sqrt(squares / double(kept)),
                            .outliers = static_cast<int>(poses->size() - kept)};
}

} // namespace carina
