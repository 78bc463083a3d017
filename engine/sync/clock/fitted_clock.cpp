#include "engine/sync/clock/fitted_clock.h"

#include "engine/core/expects.h"
#include "engine/sync/clock/weighted_line.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

// Scatter below this is the clocks' own granularity, seconds.
constexpr double kFinestScale = 1e-6;

} // namespace

ExternalOffset externalOffset(const ExternalTime& host, const ExternalTime& own, Duration age,
                              LocalTime now)
{
    const double error =
        std::hypot(toSeconds(host.error), toSeconds(own.error), kClockSkewPrior * toSeconds(age));
    return {now - age, own.offset - host.offset, fromSeconds(error)};
}

void FittedClock::addProbe(const ClockProbe& probe)
{
    const Duration atHost = probe.hostSent - probe.hostReceived;
    const Duration roundTrip = (probe.received - probe.sent) - atHost;
    if (roundTrip < Duration{})
        return;
    if (isOtherRoute(roundTrip / 2))
        reacquire();
    // Halves are added, for the sum of the wholes may not fit.
    const Duration out = probe.hostReceived.time_since_epoch() - probe.sent.time_since_epoch();
    const Duration back = probe.hostSent.time_since_epoch() - probe.received.time_since_epoch();
    m_trigger.addDelay(roundTrip / 2);
    // The offset is that of the middle of the exchange, which the host may have made long.
    const LocalTime middle = probe.sent + (probe.received - probe.sent) / 2;
    m_window.push_back({middle, out / 2 + back / 2, roundTrip});
    while (m_window.size() > kWindow || probe.received - m_window.front().at > kWindowTime)
        m_window.pop_front();
    m_lastProbe = probe.received;
    if (!isAcquiring())
        adopt(probe.received);
}

void FittedClock::reacquire()
{
    m_window.clear();
    m_trigger.reset();
    m_outsideInARow = 0;
}

bool FittedClock::isOtherRoute(Duration delay)
{
    const bool isOutside =
        m_window.size() >= kProbesToSet && m_trigger.isOutside(delay, kSigmasToFlush);
    m_outsideInARow = isOutside ? m_outsideInARow + 1 : 0;
    return m_outsideInARow == kOutsideInARow;
}

Duration FittedClock::shortestRoundTrip() const
{
    return std::ranges::min_element(m_window, {}, &Probe::roundTrip)->roundTrip;
}

FittedClock::Fit FittedClock::fit() const
{
    const Duration shortest = shortestRoundTrip();
    double scale = 0.0;
    for (const Probe& probe : m_window)
        scale += toSeconds(probe.roundTrip - shortest) / static_cast<double>(m_window.size());
    scale = std::max(scale, kFinestScale);

    WeightedLine line;
    for (const Probe& probe : m_window)
        line.add({.x = toSeconds(probe.at - m_lastProbe),
                  .y = toSeconds(probe.offset - m_window.front().offset),
                  .weight = std::exp(-kSteepness * toSeconds(probe.roundTrip - shortest) / scale)});
    const WeightedLine::Fit fitted = line.fit(kSkewPrior);
    return {fitted.atZero, std::clamp(fitted.slope, -kLargestSkew, kLargestSkew), fitted.error};
}

Duration FittedClock::fuse(LocalTime now, Duration line)
{
    m_verdict.reset();
    if (!m_external || now - m_external->at > kExternalTime)
        return Duration{};
    const Duration lineThen = line + fromSeconds(m_fit.skew * toSeconds(m_external->at - now));
    const Duration apart = m_external->offset - lineThen;
    const Duration half = shortestRoundTrip() / 2;
    const bool isRefused = std::chrono::abs(apart) > half + kErrorsToRefuse * m_external->error;
    m_verdict = ExternalVerdict{apart, m_external->error, isRefused};
    if (isRefused)
        return Duration{};
    const double ofProbes = toSeconds(half) * toSeconds(half) / 3.0 + m_fit.error * m_fit.error;
    const double external = toSeconds(m_external->error) * toSeconds(m_external->error);
    const double share = ofProbes / (ofProbes + external);
    m_fit.error = std::sqrt(external * share);
    return std::clamp(fromSeconds(share * toSeconds(apart)), -half, half);
}

void FittedClock::adopt(LocalTime now)
{
    m_fit = fit();
    const Duration line = m_window.front().offset + fromSeconds(m_fit.offset);
    const Duration moved = fuse(now, line);
    m_bound = shortestRoundTrip() / 2 + std::chrono::abs(moved);
    const Duration wanted = line + moved;
    const auto apart = [&] {
        return std::chrono::abs(m_mapping->at(now).time_since_epoch() - now.time_since_epoch()
                                - wanted);
    };
    if (!m_mapping || apart() > kLargestSlew)
        m_mapping = ClockMapping{now, wanted, m_fit.skew};
    else
        m_mapping->slewTo(wanted, now, m_fit.skew);
}

FittedClock::State FittedClock::stateAt(LocalTime t) const
{
    if (!m_mapping)
        return State::Acquiring;
    return t - m_lastProbe > kHoldoverAfter ? State::Holdover : State::Locked;
}

double FittedClock::uncertainty(LocalTime t) const
{
    CARINA_EXPECTS(m_mapping);
    const double alone = std::max(0.0, toSeconds(t - m_lastProbe - kHoldoverAfter));
    return std::min(m_fit.error, toSeconds(m_bound)) + std::abs(toSeconds(m_mapping->toGo(t)))
           + kHoldoverGrowth * alone;
}

Duration FittedClock::bound(LocalTime t) const
{
    CARINA_EXPECTS(m_mapping);
    return m_bound + std::chrono::abs(m_mapping->toGo(t));
}

} // namespace carina
