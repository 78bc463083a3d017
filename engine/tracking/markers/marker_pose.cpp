#include "engine/tracking/markers/marker_pose.h"

#include "engine/core/expects.h"
#include "engine/geometry/fit/consensus.h"
#include "engine/geometry/fit/rigid_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr std::size_t kUsualMarkers = 24; ///< markers of a probe, for which no memory is asked for

/// Corresponding points of T and O.
struct Correspondence {
    std::vector<LandmarkPair> many; ///< only of more than the usual number
    std::array<LandmarkPair, kUsualMarkers> few;
    std::span<const LandmarkPair> pairs;

    Correspondence(const Probe& probe, std::span<const SeenMarker> seen)
    {
        const bool isUsual = seen.size() <= kUsualMarkers;
        if (!isUsual)
            many.resize(seen.size());
        LandmarkPair* const to = isUsual ? few.data() : many.data();
        for (std::size_t i = 0; i < seen.size(); ++i) {
            CARINA_EXPECTS(seen[i].marker < probe.markers.size());
            to[i] = {seen[i].p_TQ, probe.markers[seen[i].marker].p_OQ};
        }
        pairs = {to, seen.size()};
    }
    Correspondence(const Correspondence&) = delete; // its span points into it
    Correspondence& operator=(const Correspondence&) = delete;
};

Result<RigidFit> fitOfMarkers(const Correspondence& all, std::span<const std::size_t> chosen)
{
    std::vector<LandmarkPair> pairs;
    for (const std::size_t i : chosen)
        pairs.push_back(all.pairs[i]);
    return fitRigid(pairs);
}

bool fitsMarkers(const Result<RigidFit>& fit, double limit)
{
    return fit && std::ranges::max(fit->residuals) <= limit;
}

/// Whether what was seen is the mirror image of the probe.
bool isMirrored(const Correspondence& all, double limit)
{
    std::vector<LandmarkPair> mirrored{all.pairs.begin(), all.pairs.end()};
    for (LandmarkPair& pair : mirrored)
        pair.p_MQ.x() = -pair.p_MQ.x();
    return fitsMarkers(fitRigid(mirrored), limit);
}

Result<MarkerPose> poseOfMost(const Correspondence& all, double limit)
{
    const std::size_t count = all.pairs.size();
    const auto distance = [&](const Result<RigidFit>& fit, std::size_t i) {
        return fit ? (all.pairs[i].p_AQ - fit->X_AM * all.pairs[i].p_MQ).norm()
                   : std::numeric_limits<double>::infinity();
    };
    const std::vector<std::size_t> agreeing = consensus(
        count, 3, limit, [&](std::span<const std::size_t> some) { return fitOfMarkers(all, some); },
        distance);
    if (2 * agreeing.size() <= count)
        return fail(Errc::DegenerateLandmarks, "the markers do not fit the tool");
    const Result<RigidFit> fit = fitOfMarkers(all, agreeing);
    if (!fit)
        return tl::unexpected(fit.error());
    MarkerPose pose{.X_TO = fit->X_AM, .rms = fit->rms};
    for (std::size_t i = 0; i < count; ++i)
        if (!std::ranges::binary_search(agreeing, i))
            pose.leftOut.push_back(i);
    return pose;
}

} // namespace

Result<MarkerPose> markerPose(const Probe& probe, std::span<const SeenMarker> seen)
{
    if (seen.size() < probe.fewest)
        return fail(Errc::TooFewLandmarks, std::to_string(seen.size()) + " markers are seen");
    const Correspondence all{probe, seen};
    const Result<RigidFit> fit = fitRigid(all.pairs);
    if (!fit && fit.error().code != Errc::DegenerateLandmarks)
        return tl::unexpected(fit.error());
    const double limit = probe.largestMisfit.si;
    if (fitsMarkers(fit, limit))
        return MarkerPose{.X_TO = fit->X_AM, .rms = fit->rms};
    if (isMirrored(all, limit))
        return fail(Errc::DegenerateLandmarks, "the markers are the mirror image of the tool");
    if (seen.size() < 4)
        return fail(Errc::DegenerateLandmarks, "the markers do not fit the tool");
    return poseOfMost(all, limit);
}

} // namespace carina
