#include "engine/scoring/course/force_meter.h"

#include <algorithm>

namespace carina
{

void ForceMeter::add(SessionTime t, Force force)
{
    if (!m_figures)
        m_figures = ForceFigures{.peakAt = t};
    else if (t <= m_last)
        return;
    else
        hold(std::min(t - m_last, kLongestGap));
    if (force > m_figures->peak) {
        m_figures->peak = force;
        m_figures->peakAt = t;
    }
    m_last = t;
    m_force = force;
}

void ForceMeter::hold(Duration time)
{
    if (m_force <= Force{})
        return;
    m_figures->touched += time;
    m_figures->impulse += inNewtons(m_force) * toSeconds(time);
    m_figures->mean = newtons(m_figures->impulse / toSeconds(m_figures->touched));
    if (m_force > m_limits.warning)
        m_figures->aboveWarning += time;
    if (m_force > m_limits.fault)
        m_figures->aboveFault += time;
}

} // namespace carina
