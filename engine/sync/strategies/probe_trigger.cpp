#include "engine/sync/strategies/probe_trigger.h"

#include <algorithm>

namespace carina
{

void ProbeTrigger::addDelay(Duration delay)
{
    m_history.add(delay);
    if (!m_rule.isAdaptive || m_history.size() < m_rule.history)
        return;
    m_rate = std::clamp(m_rate + (isOutside(delay, 1) ? 1.0 : -1.0), m_rule.lowest, m_rule.highest);
}

void ProbeTrigger::reset()
{
    m_history.clear();
    m_rate = m_rule.start;
}

bool ProbeTrigger::isOutside(Duration delay, int sigmas) const
{
    return std::chrono::abs(delay - m_history.mean())
           > sigmas * std::max(m_history.sigma(), m_rule.sigmaFloor);
}

} // namespace carina
