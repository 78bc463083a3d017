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

LocalTime ClockMapping::localAt(SessionTime t) const
{
    // Each step leaves at most a thousandth of the error: the offset changes that slowly.
    LocalTime local{t.time_since_epoch() - m_offset};
    for (int step = 0; step < 4; ++step)
        local = LocalTime{t.time_since_epoch() - offsetAt(local)};
    return local;
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
