#pragma once

#include "engine/core/session_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace carina
{

/// One delay of a trace; a datagram sent at `at` or later, up to the next point, meets it.
struct TracePoint {
    Duration at{};
    std::optional<Duration> delay; ///< nothing where it is lost
};

/// One direction of a network path. Virtual time is 0 where the experiment's first action starts.
struct PathProfile {
    /// Of what a queue adds to a datagram's delay; each datagram draws its own, so that datagrams
    /// overtake each other.
    enum class Jitter : std::uint8_t {
        None,
        Exponential, ///< of mean `jitterScale`
        Pareto,      ///< of the second kind, shape 3, mean jitterScale / 2: a heavy tail
    };
    /// Gilbert and Elliott's chain: in the bad state all is lost. It steps every 10 ms, so that
    /// these are probabilities per datagram of a stream of 100 a second.
    struct Burst {
        double enter = 0.0;
        double leave = 1.0;
    };

    Duration delay{};
    Jitter jitter = Jitter::None;
    Duration jitterScale{};
    double loss = 0.0;
    std::optional<Burst> burst{};
    double duplication = 0.0;
    double reordering = 0.0; ///< share of datagrams held up by heldUp
    Duration heldUp{};
    double bitsPerSecond = 0.0; ///< 0 for no bottleneck
    std::size_t queueBytes = 32768;
    Duration stepAt = Duration::max();
    Duration stepBy{}; ///< added to the delay from stepAt on
    Duration cutFrom = Duration::max();
    Duration cutFor{}; ///< nothing gets through for so long
    std::shared_ptr<const std::vector<TracePoint>>
        trace{}; ///< repeats; shared by all links of a run
};

/// A leg that is half the way: two in a row have the path's delay, loss and so on. A bottleneck is
/// in each of them.
[[nodiscard]] PathProfile halfOf(const PathProfile& path);

/// A path in virtual time. What happens to a datagram is a function of the seed, of the time at
/// which it is sent and of how many were sent at that very time: so it can also be asked what a
/// datagram would have met.
class VirtualLink
{
public:
    VirtualLink(PathProfile path, std::uint64_t seed);

    /// When a datagram arrives: never where it is lost, twice where it is duplicated.
    struct Arrivals {
        std::size_t count = 0;
        std::array<Duration, 2> at{};
    };
    [[nodiscard]] Arrivals send(std::size_t bytes, Duration now);

    /// The delay that the first datagram sent at `now` meets, but for the queue of the bottleneck;
    /// nothing where it is lost.
    [[nodiscard]] std::optional<Duration> delayAt(Duration now) { return delayOf(now, 0); }

private:
    enum class Draw : std::uint8_t { Loss, Jitter, Duplication, DuplicateJitter, HeldUp, Burst };

    [[nodiscard]] double unit(std::int64_t when, std::uint64_t nth, Draw draw) const;
    [[nodiscard]] bool isBad(Duration now);
    [[nodiscard]] Duration queueing(Duration now, std::uint64_t nth, Draw draw) const;
    [[nodiscard]] std::optional<Duration> baseDelay(Duration now) const;
    [[nodiscard]] std::optional<Duration> delayOf(Duration now, std::uint64_t nth);
    [[nodiscard]] std::optional<Duration> throughBottleneck(std::size_t bytes, Duration now);

    PathProfile m_path;
    std::uint64_t m_seed;
    Duration m_lastSent = Duration::min();
    std::uint64_t m_nth = 0; // datagram of that time
    Duration m_busyUntil = Duration::min();
    std::int64_t m_slot = INT64_MIN; // of the burst chain
    bool m_isBad = false;
};

} // namespace carina
