#include "engine/scoring/course/oxygen_meter.h"

namespace carina
{

void OxygenMeter::add(SessionTime t, const Vitals& vitals)
{
    const double saturation = vitals.arterialSaturation;
    if (!m_figures)
        m_figures = OxygenFigures{.first = saturation, .lowest = saturation, .lowestAt = t};
    else if (t <= m_last)
        return;
    else if (m_lastSaturation < kLowSaturation)
        m_figures->below += m_pauses.between(m_last, t);
    if (saturation < m_figures->lowest) {
        m_figures->lowest = saturation;
        m_figures->lowestAt = t;
    }
    if (saturation < kLowSaturation && !m_figures->fellBelow)
        m_figures->fellBelow = t;
    m_last = t;
    m_lastSaturation = saturation;
}

} // namespace carina
