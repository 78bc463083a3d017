#include "engine/lungs/mechanics/breath_clock.h"

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
        const double passed = breathsIn(interval);
        const Frequency rate{passed / interval};
        m_state.measured = rate < kSlowestManikin ? Frequency{} : rate;
        m_state.bridged = passed > 1.0;
    }
    if (m_state.measured.si > 0.0) {
        const double then = m_state.breaths - m_state.rate.si * secondsAgo;
        m_state.pull = std::round(then) - then;
    }
    m_state.triggered = true;
    m_state.sinceTrigger = secondsAgo;
}

/// Several where some were missed. A manikin that slows down must not be taken for one that was
/// missed: it hardly comes near a whole number, and not again and again.
double BreathClock::breathsIn(double interval) const
{
    if (!isLocked() || m_state.bridged)
        return 1.0;
    const double share = interval * m_state.measured.si;
    const double whole = std::round(share);
    const bool isNear = std::abs(share - whole) <= kNearWhole;
    return isNear && whole <= interval * kFastestManikin.si ? std::max(1.0, whole) : 1.0;
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
    if (measured > 0.0) {
        m_state.pull -= (m_state.rate.si - measured) * seconds;
        m_state.pull -= std::round(m_state.pull);
    } else {
        m_state.measured = {};
    }
}

double BreathClock::phase() const { return m_state.breaths - std::floor(m_state.breaths); }

bool BreathClock::isLocked() const
{
    return m_state.measured.si > 0.0 && m_state.sinceTrigger * m_state.measured.si < kPatience;
}

} // namespace carina
