#include "engine/tracking/markers/marker_pose.h"

#include "engine/core/expects.h"
#include "engine/geometry/fit/consensus.h"
#include "engine/geometry/fit/rigid_fit.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kUsualMarkers = 24; ///< markers of a probe, for which no memory is asked for

using MarkerPairs = std::span<const LandmarkPair>; ///< points of T and of O

/// The pairs of what was seen.
struct Correspondence {
    std::vector<LandmarkPair> many; ///< only of more than the usual number
    std::array<LandmarkPair, kUsualMarkers> few;
    MarkerPairs pairs;

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

std::vector<LandmarkPair> chosenPairs(MarkerPairs all, std::span<const std::size_t> chosen)
{
    std::vector<LandmarkPair> pairs;
    for (const std::size_t i : chosen)
        pairs.push_back(all[i]);
    return pairs;
}

/// What would have been seen of the mirror image of the probe.
std::vector<LandmarkPair> withMirroredProbe(MarkerPairs all)
{
    std::vector<LandmarkPair> mirrored{all.begin(), all.end()};
    for (LandmarkPair& pair : mirrored)
        pair.p_MQ.x() = -pair.p_MQ.x();
    return mirrored;
}

bool fitsMarkers(const Result<RigidFit>& fit, double limit)
{
    return fit && std::ranges::max(fit->residuals) <= limit;
}

/// The most markers that agree on one pose.
struct Agreement {
    std::vector<std::size_t> markers; ///< ascending; none where too few agree
    Result<RigidFit> fit;             ///< of these
};

Agreement agreementOf(MarkerPairs all, double limit)
{
    const auto fitOf = [&](std::span<const std::size_t> some) {
        return fitRigid(chosenPairs(all, some));
    };
    const auto distance = [&](const Result<RigidFit>& fit, std::size_t i) {
        return fit ? (all[i].p_AQ - fit->X_AM * all[i].p_MQ).norm()
                   : std::numeric_limits<double>::infinity();
    };
    std::vector<std::size_t> agreeing = consensus(all.size(), 3, limit, fitOf, distance);
    if (agreeing.size() < kFewestAgreeing)
        agreeing.clear();
    Result<RigidFit> fit = fitOf(agreeing);
    return {std::move(agreeing), std::move(fit)};
}

bool agreesAsWell(const Agreement& one, const Agreement& other)
{
    if (!one.fit || one.markers.size() != other.markers.size())
        return one.fit && one.markers.size() > other.markers.size();
    return one.fit->rms <= other.fit->rms;
}

/// Whether markers of a probe cannot be told from their mirror image.
bool isLikeItsImage(std::vector<LandmarkPair> markers, double limit)
{
    for (LandmarkPair& pair : markers)
        pair.p_AQ = pair.p_MQ;
    const Result<RigidFit> fit = fitRigid(withMirroredProbe(markers));
    return fit && fit->rms <= limit;
}

Result<MarkerPose> poseOfMost(MarkerPairs all, double limit)
{
    const Agreement most = agreementOf(all, limit);
    if (!most.fit || 2 * most.markers.size() <= all.size())
        return fail(Errc::DegenerateLandmarks, "the markers do not fit the tool");
    if (!isLikeItsImage(chosenPairs(all, most.markers), limit)
        && agreesAsWell(agreementOf(withMirroredProbe(all), limit), most))
        return fail(Errc::DegenerateLandmarks, "the markers are the mirror image of the tool");
    MarkerPose pose{.X_TO = most.fit->X_AM, .rms = most.fit->rms};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!std::ranges::binary_search(most.markers, i))
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
    if (fitsMarkers(fitRigid(withMirroredProbe(all.pairs)), limit))
        return fail(Errc::DegenerateLandmarks, "the markers are the mirror image of the tool");
    if (seen.size() <= kFewestAgreeing) // none can be left out
        return fail(Errc::DegenerateLandmarks, "the markers do not fit the tool");
    return poseOfMost(all.pairs, limit);
}

} // namespace carina
