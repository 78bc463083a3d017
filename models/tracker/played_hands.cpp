#include "models/tracker/played_hands.h"

#include <algorithm>
#include <utility>

namespace carina
{

PlayedHands::PlayedHands(SessionNode& node, PlayedMotion motion)
    : m_node{node}, m_motion{std::move(motion)}
{
}

HandledTools PlayedHands::at(SessionTime t) const { return m_motion.at(progressAt(t)); }

Duration PlayedHands::progressAt(SessionTime t) const
{
    const Duration begun = m_begun;
    if (begun == kNotBegun)
        return {};
    return std::max(m_node.state()->runningTime(t) - begun, Duration{});
}

void PlayedHands::look(StationId station)
{
    const auto now = m_node.now();
    const auto state = m_node.state();
    const bool isAtWork = m_node.self() != kNobody && state->atWork(station) == m_node.self();
    if (!now || !isAtWork || state->phaseAt(*now) != SessionPhase::Running)
        return;
    if (m_begun.load() == kNotBegun)
        m_begun = state->runningTime(*now);
    const Duration progress = progressAt(*now);
    for (; m_done < m_motion.controls.size() && m_motion.controls[m_done].at <= progress; ++m_done)
        m_node.propose(station, m_motion.controls[m_done].body);
}

HandMotion heldByTip(HandMotion motion, const RigidTransform& X_SP)
{
    return [motion = std::move(motion), X_PS = X_SP.inverse()](SessionTime t) {
        HandledTools held = motion(t);
        if (held.X_AS)
            held.X_AS = *held.X_AS * X_PS;
        return held;
    };
}

} // namespace carina
