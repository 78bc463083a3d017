#include "engine/sync/clock/clock_mapping.h"

#include <algorithm>
#include <cmath>

namespace carina
{

Duration ClockMapping::offsetAt(LocalTime t) const
{
    const double drifted = m_skew * static_cast<double>((t - m_start).count());
    return m_offset + Duration{std::llround(drifted)} + m_correction - toGo(t);
}

SessionTime ClockMapping::at(LocalTime t) const
{
    return SessionTime{t.time_since_epoch() + offsetAt(t)};
}

void ClockMapping::slewTo(Duration offset, LocalTime start, double skew)
{
    const Duration reached = offsetAt(start);
    m_start = start;
    m_offset = reached;
    m_skew = skew;
    m_correction = offset - reached;
}

Duration ClockMapping::toGo(LocalTime t) const
{
    const Duration worked = std::max(t - m_start, Duration{}) / kSlewDivisor;
    return m_correction - std::clamp(m_correction, -worked, worked);
}

} // namespace carina
