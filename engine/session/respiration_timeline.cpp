#include "engine/session/respiration_timeline.h"

#include <algorithm>

namespace carina
{

void RespirationTimeline::addBreath(const HeardBreath& breath)
{
    const Duration ago = breath.heard - breath.began;
    const bool inOrder = m_breaths.empty() || m_breaths.back().heard <= breath.heard;
    if (inOrder && ago >= Duration{0} && ago <= kLongestNews)
        m_breaths.push_back(breath);
}

void RespirationTimeline::addCheckpoint(const RespirationState& checkpoint)
{
    if (m_checkpoints.empty() || m_checkpoints.back().at < checkpoint.at)
        m_checkpoints.push_back(checkpoint);
}

RespiratorySettings RespirationTimeline::settingsAt(SessionTime t,
                                                    const BreathingPattern& pattern) const
{
    return {m_build.at(t), m_condition.at(t), m_tube.at(t), pattern, m_ventilator.at(t)};
}

SessionTime RespirationTimeline::changeAfter(SessionTime t) const
{
    return std::min({m_build.changeAfter(t), m_condition.changeAfter(t),
                     m_ventilator.changeAfter(t), m_tube.changeAfter(t)});
}

const RespirationState* RespirationTimeline::checkpointBefore(SessionTime t) const
{
    const auto after = std::upper_bound(
        m_checkpoints.begin(), m_checkpoints.end(), t,
        [](SessionTime time, const RespirationState& checkpoint) { return time < checkpoint.at; });
    return after == m_checkpoints.begin() ? nullptr : &*std::prev(after);
}

} // namespace carina
