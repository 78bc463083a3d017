#include "models/stylus_watch.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kSwingPoses = 480; ///< eight seconds at 60 Hz
constexpr Duration kSilence = std::chrono::milliseconds{300};
constexpr Duration kMeanOf = std::chrono::seconds{1};

/// The mean of poses that differ by no more than noise.
/// @pre there are some
RigidTransform meanOf(const std::vector<PoseSample>& samples)
{
    const Quat q_first = samples.front().X_FO.rotation();
    Vec3 p = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
    for (const PoseSample& sample : samples) {
        p += sample.X_FO.translation() / double(samples.size());
        turn += rotationVector(sample.X_FO.rotation() * q_first.inverse()) / double(samples.size());
    }
    return {rotationFromVector(turn) * q_first, p};
}

} // namespace

StylusWatch::StylusWatch(const Tracker& tracker, ReadSessionClock clock)
    : m_tools{tracker.tools()}, m_clock{std::move(clock)}
{
}

StylusWatch::News StylusWatch::look(const std::optional<Vec3>& p_SQ)
{
    News news;
    for (const PoseSample& sample : seen(ToolRole::Stylus)) {
        if (m_looked && sample.time <= *m_looked)
            continue;
        m_looked = sample.time;
        if (m_swinging && sample.validity != Validity::Lost)
            m_swing.push_back(sample.X_FO);
        if (p_SQ) {
            if (const auto touch = m_dwell.push(sample.time, sample.X_FO * *p_SQ, sample.validity))
                news.touch = touch;
        }
    }
    if (m_swinging && m_swing.size() >= kSwingPoses) {
        m_swinging = false;
        news.swing = std::exchange(m_swing, {});
    }
    return news;
}

void StylusWatch::startSwing()
{
    m_swing.clear();
    m_swinging = true;
}

double StylusWatch::swingProgress() const
{
    return m_swinging ? double(m_swing.size()) / double(kSwingPoses) : 0.0;
}

std::optional<RigidTransform> StylusWatch::stylus() const
{
    const std::vector<PoseSample> samples = seen(ToolRole::Stylus);
    if (samples.empty() || samples.back().validity == Validity::Lost)
        return std::nullopt;
    return samples.back().X_FO;
}

std::optional<RigidTransform> StylusWatch::chin() const
{
    std::vector<PoseSample> samples = seen(ToolRole::Jaw);
    if (samples.empty())
        return std::nullopt;
    const SessionTime from = samples.back().time - kMeanOf;
    std::erase_if(samples, [from](const PoseSample& sample) {
        return sample.validity == Validity::Lost || sample.time < from;
    });
    return samples.empty() ? std::nullopt : std::optional{meanOf(samples)};
}

std::vector<PoseSample> StylusWatch::seen(ToolRole role) const
{
    const auto now = m_clock();
    const auto tool = std::ranges::find(m_tools, role, &TrackedTool::role);
    if (!now || tool == m_tools.end())
        return {};
    std::vector<PoseSample> samples = tool->history->samples();
    if (samples.empty() || *now - samples.back().time > kSilence)
        return {};
    return samples;
}

} // namespace carina
