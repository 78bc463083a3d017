#include "evaluation/network/virtual_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// The last delay of a trace holds for as long as the one before it, a lone one for a second.
Duration lengthOf(const std::vector<TracePoint>& points)
{
    const Duration last = points.size() > 1 ? points.back().at - points[points.size() - 2].at
                                            : Duration{std::chrono::seconds{1}};
    return points.back().at - points.front().at + last;
}

constexpr Duration kBurstSlot = std::chrono::milliseconds{10};
// IP and UDP around each payload.
constexpr std::size_t kHeaderBytes = 28;

/// SplitMix64's finaliser (Steele et al. 2014).
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31);
}

/// The probability per leg of what happens with probability p over two.
double perLeg(double p) { return 1.0 - std::sqrt(1.0 - p); }

} // namespace

PathProfile halfOf(const PathProfile& path)
{
    PathProfile leg = path;
    leg.delay /= 2;
    leg.jitterScale /= 2;
    leg.loss = perLeg(path.loss);
    if (leg.burst)
        leg.burst->enter /= 2.0;
    leg.duplication = perLeg(path.duplication);
    leg.reordering = perLeg(path.reordering);
    leg.stepBy /= 2;
    if (path.trace) {
        std::vector<TracePoint> points = *path.trace;
        for (TracePoint& point : points)
            if (point.delay)
                *point.delay /= 2;
        leg.trace = std::make_shared<const std::vector<TracePoint>>(std::move(points));
    }
    return leg;
}

VirtualLink::VirtualLink(PathProfile path, std::uint64_t seed)
    : m_path{std::move(path)}, m_seed{mixed(seed)}
{
}

double VirtualLink::unit(std::int64_t when, std::uint64_t nth, Draw draw) const
{
    const std::uint64_t which = nth * 8 + static_cast<std::uint64_t>(draw);
    const std::uint64_t bits = mixed(mixed(m_seed ^ static_cast<std::uint64_t>(when)) + which);
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

bool VirtualLink::isBad(Duration now)
{
    if (!m_path.burst)
        return false;
    const std::int64_t slot = now.count() / kBurstSlot.count() - (now.count() < 0 ? 1 : 0);
    // Asked for a time before the last, or for the first time: from the good state at a fixed slot
    // some way back, where any two chains have met.
    if (slot < m_slot || m_slot == INT64_MIN) {
        constexpr std::int64_t kMemory = 1024;
        m_slot = (slot / kMemory - 2) * kMemory;
        m_isBad = false;
    }
    while (m_slot < slot) {
        const double drawn = unit(++m_slot, 0, Draw::Burst);
        m_isBad = m_isBad ? drawn >= m_path.burst->leave : drawn < m_path.burst->enter;
    }
    return m_isBad;
}

Duration VirtualLink::queueing(Duration now, std::uint64_t nth, Draw draw) const
{
    const double scale = toSeconds(m_path.jitterScale);
    const double left = 1.0 - unit(now.count(), nth, draw);
    switch (m_path.jitter) {
    case PathProfile::Jitter::Exponential:
        return fromSeconds(-scale * std::log(left));
    case PathProfile::Jitter::Pareto:
        return fromSeconds(scale * (std::cbrt(1.0 / left) - 1.0));
    case PathProfile::Jitter::Uniform:
        return fromSeconds(scale * (1.0 - 2.0 * left));
    case PathProfile::Jitter::None:
        break;
    }
    return Duration{};
}

std::optional<Duration> VirtualLink::baseDelay(Duration now) const
{
    Duration delay = m_path.delay + (now >= m_path.stepAt ? m_path.stepBy : Duration{});
    if (!m_path.trace)
        return delay;
    const auto& points = *m_path.trace;
    const Duration length = lengthOf(points);
    Duration phase = now % length;
    if (phase < Duration{})
        phase += length;
    const auto after =
        std::ranges::upper_bound(points, points.front().at + phase, {}, &TracePoint::at);
    if (!std::prev(after)->delay)
        return std::nullopt;
    return delay + *std::prev(after)->delay;
}

std::optional<Duration> VirtualLink::delayOf(Duration now, std::uint64_t nth)
{
    const bool isCut = now >= m_path.cutFrom && now < m_path.cutFrom + m_path.cutFor;
    const auto base = baseDelay(now);
    if (isCut || !base || isBad(now) || unit(now.count(), nth, Draw::Loss) < m_path.loss)
        return std::nullopt;
    const bool isHeldUp = unit(now.count(), nth, Draw::HeldUp) < m_path.reordering;
    return *base + queueing(now, nth, Draw::Jitter) + (isHeldUp ? m_path.heldUp : Duration{});
}

std::optional<Duration> VirtualLink::throughBottleneck(std::size_t bytes, Duration now)
{
    if (m_path.bitsPerSecond <= 0.0)
        return now;
    const auto time = [&](std::size_t count) {
        return fromSeconds(8.0 * static_cast<double>(count) / m_path.bitsPerSecond);
    };
    const Duration start = std::max(now, m_busyUntil);
    if (start - now > time(m_path.queueBytes))
        return std::nullopt;
    m_busyUntil = start + time(bytes + kHeaderBytes);
    return m_busyUntil;
}

VirtualLink::Arrivals VirtualLink::send(std::size_t bytes, Duration now)
{
    m_nth = now == m_lastSent ? m_nth + 1 : 0;
    m_lastSent = now;
    const auto out = throughBottleneck(bytes, now);
    const auto delay = delayOf(now, m_nth);
    if (!out || !delay)
        return {};
    Arrivals arrivals{1, {*out + *delay}};
    if (unit(now.count(), m_nth, Draw::Duplication) < m_path.duplication)
        arrivals = {2,
                    {*out + *delay, *out + *delay + queueing(now, m_nth, Draw::DuplicateJitter)}};
    return arrivals;
}

} // namespace carina
