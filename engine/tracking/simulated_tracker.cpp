#include "engine/tracking/simulated_tracker.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

constexpr Duration kLongestCatchUp = std::chrono::seconds{1};
constexpr double kMarkersPerTool = 4.0;

} // namespace

SimulatedTracker::SimulatedTracker(SimulatedTrackerSettings settings, TrueToolPose truth,
                                   ReadSessionClock clock)
    : m_settings{std::move(settings)},
      m_truth{std::move(truth)},
      m_random{m_settings.seed},
      m_thread{std::move(clock), [this](SessionTime now) { return advance(now); }}
{
    CARINA_EXPECTS(m_settings.rate > hertz(0.0));
    const auto add = [this](const char* name, ToolRole role) {
        Probe& probe = m_probes.emplace_back();
        probe.role = role;
        m_tools.push_back({name, role, &probe.history});
    };
    add("head", ToolRole::Head);
    add("jaw", ToolRole::Jaw);
    add("tube", ToolRole::Tube);
    add("stylus", ToolRole::Stylus);
    if (m_settings.chestMarker)
        add("chest", ToolRole::Chest);
    if (m_settings.bodyProbe)
        add("body", ToolRole::Manikin);
    if (m_settings.handProbe)
        add("hand", ToolRole::Hand);
}

SessionTime SimulatedTracker::advance(SessionTime now)
{
    if (!m_firstTick || std::chrono::abs(now - nextTick()) > kLongestCatchUp) {
        m_firstTick = now;
        m_ticks = 0;
        m_underway.clear();
    }
    for (; nextTick() <= now; ++m_ticks) {
        for (Probe& probe : m_probes)
            expose(probe, nextTick());
    }
    while (!m_underway.empty() && m_underway.front().sample.time + m_settings.latency <= now) {
        Probe& probe = *m_underway.front().probe;
        probe.history.push(probe.filter.moving(m_underway.front().sample));
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

bool SimulatedTracker::hidden(ToolRole role, SessionTime t) const
{
    return std::ranges::any_of(m_settings.occlusions, [&](const Occlusion& occlusion) {
        return occlusion.tool == role && occlusion.from <= t && t < occlusion.until;
    });
}

void SimulatedTracker::expose(Probe& probe, SessionTime t)
{
    const std::optional<RigidTransform> X_TO = m_truth(probe.role, t);
    const bool seen =
        X_TO && !hidden(probe.role, t) && m_settings.volume.contains(X_TO->translation());
    if (seen)
        probe.lastX_TO = measured(*X_TO);
    if (!probe.lastX_TO)
        return;
    PoseSample sample{.time = t, .X_FO = *probe.lastX_TO};
    if (seen)
        sample.error = std::sqrt(kMarkersPerTool - 2.0) * noiseAlong(-Vec3::UnitZ()).norm();
    else
        sample.validity = Validity::Lost;
    m_underway.push_back({&probe, sample});
}

RigidTransform SimulatedTracker::measured(const RigidTransform& X_TO)
{
    const double perAxis = m_settings.rotationNoise.si / std::sqrt(3.0);
    Vec3 turn_T;
    for (double& component : turn_T)
        component = perAxis * m_normal(m_random);
    return {rotationFromVector(turn_T) * X_TO.rotation(),
            X_TO.translation() + noiseAlong(X_TO.translation())};
}

// Two lateral components and one in depth: RMS^2 = (2 + ratio^2) lateral^2.
Vec3 SimulatedTracker::noiseAlong(const Vec3& sight_T)
{
    const double ratio = m_settings.depthRatio;
    const double lateral = m_settings.positionNoise.si / std::sqrt(2.0 + ratio * ratio);
    Vec3 noise_S; // S: z along the line of sight
    for (double& component : noise_S)
        component = lateral * m_normal(m_random);
    noise_S.z() *= ratio;
    return Quat::FromTwoVectors(Vec3::UnitZ(), sight_T) * noise_S;
}

} // namespace carina
