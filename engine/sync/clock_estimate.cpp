#include "engine/sync/clock_estimate.h"

#include "engine/core/expects.h"

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

void ClockEstimate::addProbe(const ClockProbe& probe)
{
    const Duration atHost = probe.hostSent - probe.hostReceived;
    const Duration roundTrip = (probe.received - probe.sent) - atHost;
    if (roundTrip < Duration{})
        return;
    // Halves are added, for the sum of the wholes may not fit.
    const Duration out = probe.hostReceived.time_since_epoch() - probe.sent.time_since_epoch();
    const Duration back = probe.hostSent.time_since_epoch() - probe.received.time_since_epoch();
    const Measurement measured{out / 2 + back / 2, roundTrip / 2, probe.received};
    if (m_probes == 0 || measured.halfRoundTrip <= boundOf(*m_best, probe.received))
        m_best = measured;
    m_probes = std::min(m_probes + 1, kProbesToSet);
    if (!isAcquiring())
        adopt(probe.received);
}

void ClockEstimate::adopt(LocalTime now)
{
    const Duration wanted = m_best->offset;
    const auto apart = [&] {
        return std::chrono::abs(m_mapping->at(now).time_since_epoch() - now.time_since_epoch()
                                - wanted);
    };
    if (!m_mapping || apart() > kLargestSlew)
        m_mapping = ClockMapping{now, wanted};
    else
        m_mapping->slewTo(wanted, now);
}

Duration ClockEstimate::uncertainty(LocalTime t) const
{
    CARINA_EXPECTS(m_mapping && m_best);
    return boundOf(*m_best, t) + std::chrono::abs(m_mapping->toGo(t));
}

Duration ClockEstimate::boundOf(const Measurement& measured, LocalTime t)
{
    return measured.halfRoundTrip + (t - measured.received) / kSkewAllowanceDivisor;
}

} // namespace carina
