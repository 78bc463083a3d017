#include "engine/registration/calibration/pivot_calibration.h"

#include "engine/geometry/fit/consensus.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// Three poses determine a tip; four do so even if two of them are equal.
constexpr std::size_t kPivotSample = 4;

struct Pivot {
    Vec3 p_SQ;
    Vec3 p_TQ;
};

Pivot pivotOf(const PoseMeans& means)
{
    const Vec3 p_SQ = means.turn.ldlt().solve(means.shift);
    return {p_SQ, means.R * p_SQ + means.p};
}

double tipDistance(const Pivot& pivot, const TurnedPose& pose)
{
    return (pose.R_TS * pivot.p_SQ + pose.p_TS - pivot.p_TQ).norm();
}

std::vector<std::size_t> agreeingPoses(std::span<const TurnedPose> poses, Length limit)
{
    return consensus(
        poses.size(), kPivotSample, limit.si,
        [&](std::span<const std::size_t> some) { return pivotOf(meansOf(poses, some)); },
        [&](const Pivot& pivot, std::size_t i) { return tipDistance(pivot, poses[i]); });
}

Error tooFewAgree(std::size_t poses, std::size_t kept)
{
    return {Errc::ToolMoved, "of " + std::to_string(poses) + " poses no more than "
                                 + std::to_string(kept) + " agree about the tip"};
}

Error strayed(Length rms, Length largest)
{
    return {Errc::ToolMoved, "the tip strayed from the divot by " + inWords(rms) + " (RMS), and "
                                 + inWords(largest) + " are the most"};
}

} // namespace

Result<void> checkTurns(const TurnCoverage& coverage, Angle leastTurn)
{
    if (coverage.turns[1] < leastTurn)
        return fail(Errc::NotEnoughMotion, "the stylus was hardly turned: two directions of it by "
                                           "no more than "
                                               + inWords(coverage.turns[1]) + ", and "
                                               + inWords(leastTurn) + " are due");
    if (coverage.turns[0] < leastTurn)
        return fail(Errc::NotEnoughMotion,
                    "the stylus was turned about one axis only: its direction "
                        + inWords(coverage.dirs_S[0]) + " turned by " + inWords(coverage.turns[0])
                        + ", and " + inWords(leastTurn) + " are due");
    return {};
}

Result<PivotCalibration> calibratePivot(std::span<const RigidTransform> X_TS,
                                        const PivotSettings& settings)
{
    const auto poses = turnedPoses(X_TS);
    if (!poses)
        return tl::unexpected(poses.error());
    const std::vector<std::size_t> kept = agreeingPoses(*poses, settings.outlierLimit);
    const bool areFew = 2 * kept.size() < poses->size();
    if (kept.size() < kFewestPoses)
        return tl::unexpected(tooFewAgree(poses->size(), kept.size()));
    const PoseMeans means = meansOf(*poses, kept);
    const TurnCoverage coverage = means.coverage();
    if (const auto turned = checkTurns(coverage, settings.leastTurn); !turned)
        return tl::unexpected(areFew ? tooFewAgree(poses->size(), kept.size()) : turned.error());
    const Pivot pivot = pivotOf(means);
    double squares = 0.0;
    for (const std::size_t i : kept)
        squares += std::pow(tipDistance(pivot, (*poses)[i]), 2);
    const auto count = double(kept.size());
    const double rms = std::sqrt(squares / count);
    std::optional<Error> refusal;
    if (areFew)
        refusal = tooFewAgree(poses->size(), kept.size());
    else if (rms > settings.largestRms.si)
        refusal = strayed(metres(rms), settings.largestRms);
    return PivotCalibration{.p_SQ = pivot.p_SQ,
                            .p_TQ = pivot.p_TQ,
                            .rms = rms,
                            .outliers = static_cast<int>(poses->size() - kept.size()),
                            .covariance_S =
                                squares / (3.0 * count - 6.0) / count * means.turn.inverse(),
                            .coverage = coverage,
                            .refusal = std::move(refusal)};
}

} // namespace carina
