#include "models/respiration/manikin_breaths.h"

namespace carina
{

ManikinBreaths::ManikinBreaths(SessionNode& node, PoseSource marker, QObject* parent)
    : QObject{parent}, m_node{node}, m_marker{std::move(marker)}
{
    m_timer.callOnTimeout(this, &ManikinBreaths::look);
    m_timer.start(kInterval_ms);
}

void ManikinBreaths::look()
{
    const auto sample = m_marker();
    if (!sample || sample->validity == Validity::Lost)
        return;
    // A chest rises forward, against +y of A, however the tracker stands.
    const double height = -sample->X_FO.translation().y();
    const auto began = m_detector.add(sample->time, height);
    const auto now = m_node.now();
    if (began && now && m_node.self() != kNobody
        && m_node.state()->phaseAt(*now) == SessionPhase::Running)
        m_node.propose(ownStation(m_node), fact::ManikinBreathed{*began});
}

} // namespace carina
