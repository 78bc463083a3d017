#include "engine/registration/landmarks/layout_check.h"

#include "engine/geometry/fit/point_check.h"

namespace carina
{

Result<LayoutReport> checkLayout(std::span<const LandmarkError> landmarks,
                                 std::span<const Vec3> targets, Length limit, Weighting weighting)
{
    if (targets.empty())
        return fail(Errc::OutOfRange, "there is no target");
    const Result<Mat6> covariance = fitCovariance(landmarks, weighting);
    if (!covariance)
        return tl::unexpected(covariance.error());
    LayoutReport report;
    for (const Vec3& target : targets) {
        if (const auto sound = checkPoint(target, "a target"); !sound)
            return tl::unexpected(sound.error());
        report.targets.push_back(targetError(*covariance, target));
        if (report.targets.back().rms > report.targets[report.worst].rms)
            report.worst = report.targets.size() - 1;
    }
    report.withinLimit = report.targets[report.worst].rms <= limit;
    return report;
}

Result<std::optional<NextLandmark>> nextLandmark(std::span<const LandmarkError> landmarks,
                                                 std::span<const LandmarkError> candidates,
                                                 std::span<const Vec3> targets, Weighting weighting)
{
    const Result<LayoutReport> now = checkLayout(landmarks, targets, {}, weighting);
    if (!now)
        return tl::unexpected(now.error());
    std::optional<NextLandmark> best;
    Length least = now->targets[now->worst].rms;
    std::vector<LandmarkError> extended{landmarks.begin(), landmarks.end()};
    extended.emplace_back();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        extended.back() = candidates[i];
        const Result<LayoutReport> then = checkLayout(extended, targets, {}, weighting);
        if (!then)
            return tl::unexpected(then.error());
        const Length worst = then->targets[then->worst].rms;
        if (worst < least) {
            least = worst;
            best = NextLandmark{i, worst};
        }
    }
    return best;
}

} // namespace carina
