#include "engine/session/breathing_timeline.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

using Breaths = std::chrono::duration<double>; // breaths per second, times seconds

} // namespace

void BreathingTimeline::setRate(SessionTime from, Frequency rate)
{
    CARINA_EXPECTS(std::isfinite(rate.si) && rate.si >= 0.0);
    m_rate.set(from, rate);
    refreshSpeed(from, m_rate.changeAfter(from));
}

void BreathingTimeline::setTidalVolume(SessionTime from, Volume tidalVolume)
{
    m_tidalVolume.set(from, tidalVolume);
}

void BreathingTimeline::setInspiratoryFraction(SessionTime from, double fraction)
{
    CARINA_EXPECTS(fraction >= 0.1 && fraction <= 0.9);
    m_inspiratoryFraction.set(from, fraction);
}

void BreathingTimeline::setRunning(SessionTime from, bool running)
{
    m_running.set(from, running);
    refreshSpeed(from, m_running.changeAfter(from));
}

/// Sets the speed anew in [from, until), where rate or running has just changed.
void BreathingTimeline::refreshSpeed(SessionTime from, SessionTime until)
{
    const auto setAt = [this](SessionTime t) {
        m_speed.set(t, m_running.at(t) ? m_rate.at(t).si : 0.0);
    };
    setAt(from);
    for (SessionTime t = m_rate.changeAfter(from); t < until; t = m_rate.changeAfter(t))
        setAt(t);
    for (SessionTime t = m_running.changeAfter(from); t < until; t = m_running.changeAfter(t))
        setAt(t);
}

BreathingPattern BreathingTimeline::settingsAt(SessionTime t) const
{
    return {m_rate.at(t), m_tidalVolume.at(t), m_inspiratoryFraction.at(t)};
}

SessionTime BreathingTimeline::changeAfter(SessionTime t) const
{
    return std::min({m_rate.changeAfter(t), m_tidalVolume.changeAfter(t),
                     m_inspiratoryFraction.changeAfter(t), m_running.changeAfter(t)});
}

double BreathingTimeline::breathsAt(SessionTime t) const
{
    return Breaths{m_speed.integral(t)}.count();
}

/// When the breath of that number began, as seen from t in that breath: the last time at which no
/// more than so many breaths were done. Lungs that rest between two breaths while settings change
/// thus take the newest ones into the next breath.
SessionTime BreathingTimeline::breathStart(double breath, SessionTime t) const
{
    using Change = ParameterTimeline<double>::Change;
    const auto changes = m_speed.changes();
    const auto next = std::upper_bound(
        changes.begin(), changes.end(), breath,
        [](double count, const Change& change) { return count < Breaths{change.before}.count(); });
    if (next == changes.begin())
        return t;
    const Change& inForce = *std::prev(next);
    if (inForce.value == 0.0)
        return t;
    const double missing = breath - Breaths{inForce.before}.count();
    return std::min(t, inForce.from + fromSeconds(missing / inForce.value));
}

Volume BreathingTimeline::inspiredAt(SessionTime t) const
{
    const double breaths = breathsAt(t);
    const double whole = std::floor(breaths);
    return inspiredVolume(settingsAt(breathStart(whole, t)), breaths - whole);
}

} // namespace carina
