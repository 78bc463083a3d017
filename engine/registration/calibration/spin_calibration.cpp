#include "engine/registration/calibration/spin_calibration.h"

#include "engine/geometry/fit/consensus.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Two poses determine an axis; a third one reveals a wrong axis.
constexpr std::size_t kSpinSample = 3;

struct Axis {
    Vec3 dir_S;
    Vec3 dir_T; ///< on average
};

Axis axisOf(const PoseMeans& means)
{
    const Vec3 dir_S = means.coverage().dirs_S[0];
    return {dir_S, (means.R * dir_S).normalized()};
}

/// As the chord, which near zero is the angle in radians.
double leanOf(const Axis& axis, const TurnedPose& pose)
{
    return (pose.R_TS * axis.dir_S - axis.dir_T).norm();
}

/// The point of the axis nearest to the origin of S: the pivot calibration restricted to the two
/// directions across the axis.
Vec3 pointOf(const PoseMeans& means, const TurnCoverage& coverage)
{
    Eigen::Matrix<double, 3, 2> across_S;
    across_S << coverage.dirs_S[1], coverage.dirs_S[2];
    const Eigen::Matrix2d turn = across_S.transpose() * means.turn * across_S;
    return across_S * turn.inverse() * across_S.transpose() * means.shift;
}

/// RMS distance of the point from its mean, across the axis.
double strayOf(std::span<const TurnedPose> poses, std::span<const std::size_t> which,
               const PoseMeans& means, const Axis& axis, const Vec3& p_SC)
{
    const Vec3 p_TC = means.R * p_SC + means.p;
    double squares = 0.0;
    for (const std::size_t i : which)
        squares += axis.dir_T.cross(poses[i].R_TS * p_SC + poses[i].p_TS - p_TC).squaredNorm();
    return std::sqrt(squares / double(which.size()));
}

std::optional<Error> wobbled(Angle wobble, Angle largest)
{
    if (wobble <= largest)
        return std::nullopt;
    return Error{Errc::ToolMoved, "the axis wobbled by " + inWords(wobble) + " (RMS), and "
                                      + inWords(largest) + " are the most"};
}

} // namespace

Result<SpinCalibration> calibrateSpin(std::span<const RigidTransform> X_TS, const Vec3& p_S_ahead,
                                      const SpinSettings& settings)
{
    const auto poses = turnedPoses(X_TS);
    if (!poses)
        return tl::unexpected(poses.error());
    const std::vector<std::size_t> kept = consensus(
        poses->size(), kSpinSample, settings.outlierLimit.si,
        [&](std::span<const std::size_t> some) { return axisOf(meansOf(*poses, some)); },
        [&](const Axis& axis, std::size_t i) { return leanOf(axis, (*poses)[i]); });
    if (kept.size() < std::max(kFewestPoses, (poses->size() + 1) / 2))
        return fail(Errc::ToolMoved, "of " + std::to_string(poses->size()) + " poses no more than "
                                         + std::to_string(kept.size()) + " agree about the axis");
    const PoseMeans means = meansOf(*poses, kept);
    const TurnCoverage coverage = means.coverage();
    if (coverage.turns[1] < settings.leastTurn)
        return fail(Errc::NotEnoughSpin, "it turned about its axis by " + inWords(coverage.turns[1])
                                             + ", and " + inWords(settings.leastTurn) + " are due");
    Axis axis = axisOf(means);
    const Vec3 p_SC = pointOf(means, coverage);
    if (axis.dir_S.dot(p_S_ahead) < 0.0)
        axis = {-axis.dir_S, -axis.dir_T};
    const double across = std::hypot(1.0 / coverage.turns[1].si, 1.0 / coverage.turns[2].si);
    return SpinCalibration{.axis_S = axis.dir_S,
                           .p_SC = p_SC,
                           .wobble = coverage.turns[0],
                           .rms = strayOf(*poses, kept, means, axis, p_SC),
                           .outliers = static_cast<int>(poses->size() - kept.size()),
                           .uncertainty =
                               coverage.turns[0] * (across / std::sqrt(2.0 * double(kept.size()))),
                           .coverage = coverage,
                           .refusal = wobbled(coverage.turns[0], settings.largestWobble)};
}

} // namespace carina
