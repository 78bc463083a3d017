#include "engine/tracking/simulated/simulated_tracker.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"
#include "engine/tracking/markers/marker_search.h"

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

constexpr Duration kLongestCatchUp = std::chrono::seconds{1};
constexpr double kPartlySeen = 2.0 / 3.0; ///< of the markers that face the tracker
constexpr double kNoiseWithinFit = 6.0;

/// Markers all round a ball, moved from their places so that no two distances are alike.
Probe ballOf(int markers, Length radius, std::uint32_t seed)
{
    std::mt19937 random{seed};
    const auto part = [&random](double size) {
        return size * (double(random()) / double(std::mt19937::max()) - 0.5);
    };
    Probe probe;
    probe.largestMisfit = millimetres(1.0);
    for (const Vec3& even : directionsAllRound(markers)) {
        const Vec3 direction = (even + Vec3{part(0.5), part(0.5), part(0.5)}).normalized();
        const double distance = radius.si * (0.9 + part(0.4));
        probe.markers.push_back({distance * direction, direction});
    }
    return probe;
}

/// The markers that a pose was computed from; nothing of a probe with more than a set has.
std::optional<MarkerSet> markersOf(const Probe& probe, std::span<const SeenMarker> seen,
                                   const MarkerPose& pose)
{
    MarkerSet markers;
    if (probe.markers.size() > markers.size())
        return std::nullopt;
    for (const SeenMarker& each : seen)
        markers.set(each.marker);
    for (const std::size_t i : pose.leftOut)
        markers.reset(seen[i].marker);
    return markers;
}

bool isUnderWay(const Occlusion& occlusion, SessionTime t)
{
    Duration since = t - occlusion.from;
    if (occlusion.every > Duration::zero() && since > Duration::zero())
        since %= occlusion.every;
    return since >= Duration::zero() && since < occlusion.until - occlusion.from;
}

} // namespace

Probe simulatedProbe(ToolRole role)
{
    if (role == ToolRole::Head)
        return ballOf(20, millimetres(100.0), 1);
    return ballOf(12, millimetres(45.0), 100U + static_cast<std::uint32_t>(role));
}

SimulatedTracker::SimulatedTracker(SimulatedTrackerSettings settings, TrueToolPose truth,
                                   ReadSessionClock clock)
    : m_settings{std::move(settings)},
      m_truth{std::move(truth)},
      m_random{m_settings.seed},
      m_drops{m_settings.seed},
      m_thread{std::move(clock), [this](SessionTime now) { return advance(now); }}
{
    CARINA_EXPECTS(m_settings.rate > hertz(0.0));
    const auto add = [this](const std::string& name, ToolRole role) {
        Tool& tool = m_tracked.emplace_back();
        tool.role = role;
        const auto probe = m_settings.probes.find(role);
        tool.probe = probe == m_settings.probes.end() ? simulatedProbe(role) : probe->second;
        tool.probe.largestMisfit =
            std::max(tool.probe.largestMisfit, kNoiseWithinFit * m_settings.noise.rms);
        m_tools.push_back({name, role, &tool.history, tool.probe, m_settings.noise});
    };
    add("head", ToolRole::Head);
    add("jaw", ToolRole::Jaw);
    add("tube", ToolRole::Tube);
    add(kSimulatedStylus, ToolRole::Stylus);
    if (m_settings.chestMarker)
        add("chest", ToolRole::Chest);
    if (m_settings.bodyProbe)
        add("body", ToolRole::Manikin);
    if (m_settings.handProbe)
        add("hand", ToolRole::Hand);
    if (m_settings.laryngoscope)
        add(m_settings.laryngoscopeName, ToolRole::Laryngoscope);
}

SessionTime SimulatedTracker::advance(SessionTime now)
{
    if (!m_firstTick || std::chrono::abs(now - nextTick()) > kLongestCatchUp) {
        m_firstTick = now;
        m_ticks = 0;
        m_underway.clear();
    }
    for (; nextTick() <= now; ++m_ticks) {
        if (isDropped())
            continue;
        for (Tool& tool : m_tracked)
            expose(tool, nextTick());
    }
    while (!m_underway.empty() && m_underway.front().sample.time + m_settings.latency <= now) {
        Tool& tool = *m_underway.front().tool;
        tool.history.push(m_underway.front().sample);
        m_underway.pop_front();
    }
    if (m_underway.empty())
        return nextTick();
    return std::min(nextTick(), m_underway.front().sample.time + m_settings.latency);
}

SessionTime SimulatedTracker::nextTick() const
{
    return *m_firstTick + fromSeconds(static_cast<double>(m_ticks) / m_settings.rate.si);
}

bool SimulatedTracker::isDropped()
{
    return m_settings.dropouts > 0.0
           && double(m_drops()) / double(std::mt19937::max()) < m_settings.dropouts;
}

double SimulatedTracker::hiddenShare(ToolRole role, SessionTime t) const
{
    double share = 0.0;
    for (const Occlusion& occlusion : m_settings.occlusions)
        if (occlusion.tool == role && isUnderWay(occlusion, t))
            share = std::max(share, occlusion.share);
    return share;
}

void SimulatedTracker::expose(Tool& tool, SessionTime t)
{
    const std::optional<RigidTransform> X_TO = m_truth(tool.role, t);
    std::optional<PoseSample> sample;
    if (X_TO && m_settings.volume.contains(X_TO->translation()))
        sample = measured(tool, *X_TO, t);
    tool.isSeen = sample.has_value();
    if (sample)
        tool.lastX_TO = sample->X_FO;
    else if (tool.lastX_TO)
        sample = {.time = t, .X_FO = *tool.lastX_TO, .validity = Validity::Lost};
    else
        return;
    m_underway.push_back({&tool, *sample});
}

std::optional<PoseSample> SimulatedTracker::measured(Tool& tool, const RigidTransform& X_TO,
                                                     SessionTime t)
{
    const Vec3 d_O = X_TO.rotation().conjugate() * -X_TO.translation().stableNormalized();
    const std::vector<std::size_t> facing = facingMarkers(tool.probe, d_O);
    const auto hidden = std::size_t(std::ceil(hiddenShare(tool.role, t) * double(facing.size())));
    std::vector<SeenMarker> seen;
    std::vector<Vec3> points;
    for (std::size_t i = hidden; i < facing.size(); ++i) {
        const ToolMarker& marker = tool.probe.markers[facing[i]];
        const Vec3 p_TQ = X_TO * Vec3{marker.p_OQ + m_settings.noise.outward.si * marker.normal_O};
        seen.push_back({.marker = facing[i], .p_TQ = p_TQ + noiseAlong(p_TQ)});
        points.push_back(seen.back().p_TQ);
    }
    if (!tool.isSeen) {
        auto found = searchMarkers(tool.probe, points);
        if (!found)
            return std::nullopt;
        seen = *std::move(found);
    }
    const Result<MarkerPose> pose = markerPose(tool.probe, seen);
    if (!pose)
        return std::nullopt;
    const bool isPartly = double(seen.size()) < kPartlySeen * double(facing.size());
    return PoseSample{.time = t,
                      .X_FO = pose->X_TO,
                      .validity = isPartly ? Validity::PartlyOccluded : Validity::Tracked,
                      .error = pose->rms,
                      .markers = markersOf(tool.probe, seen, *pose)};
}

// Two lateral components and one in depth: RMS^2 = (2 + ratio^2) lateral^2.
Vec3 SimulatedTracker::noiseAlong(const Vec3& sight_T)
{
    const double ratio = m_settings.noise.depthRatio;
    const double lateral = m_settings.noise.rms.si / std::sqrt(2.0 + ratio * ratio);
    Vec3 noise_S; // S: z along the line of sight
    for (double& component : noise_S)
        component = lateral * m_normal(m_random);
    noise_S.z() *= ratio;
    return Quat::FromTwoVectors(Vec3::UnitZ(), sight_T) * noise_S;
}

} // namespace carina
