#include "engine/lungs/breath_clock.h"

#include <algorithm>
#include <cmath>

namespace carina
{

void BreathClock::trigger(double secondsAgo)
{
    const double interval = m_state.sinceTrigger - secondsAgo;
    if (m_state.triggered && interval * kFastestManikin.si < 1.0)
        return;
    if (m_state.triggered) {
        // Where the rate is known, several breaths may have passed.
        const double passed =
            isLocked() ? std::max(1.0, std::round(interval * m_state.measured.si)) : 1.0;
        const Frequency rate{passed / interval};
        m_state.measured = rate < kSlowestManikin ? Frequency{} : rate;
    }
    if (m_state.measured.si > 0.0) {
        const double then = m_state.breaths - m_state.rate.si * secondsAgo;
        m_state.pull = std::round(then) - then;
    }
    m_state.triggered = true;
    m_state.sinceTrigger = secondsAgo;
}

void BreathClock::advance(Frequency set, double seconds)
{
    const double measured = isLocked() ? m_state.measured.si : 0.0;
    double aim = set.si;
    if (measured > 0.0)
        aim = measured * (1.0 + std::clamp(m_state.pull, -kMostPull, kMostPull));
    const double most = kSlew * std::max(aim, m_state.rate.si) * seconds;
    m_state.rate.si += std::clamp(aim - m_state.rate.si, -most, most);
    m_state.breaths += m_state.rate.si * seconds;
    m_state.sinceTrigger += seconds;
    if (measured > 0.0)
        m_state.pull -= (m_state.rate.si - measured) * seconds;
    else
        m_state.measured = {};
}

double BreathClock::phase() const { return m_state.breaths - std::floor(m_state.breaths); }

bool BreathClock::isLocked() const
{
    return m_state.measured.si > 0.0 && m_state.sinceTrigger * m_state.measured.si < kPatience;
}

} // namespace carina
