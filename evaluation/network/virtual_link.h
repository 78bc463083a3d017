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

/// One delay of a trace; it applies to datagrams sent from `at` until the next point.
struct TracePoint {
    Duration at{};
    std::optional<Duration> delay; ///< empty: the datagram is lost
};

/// One direction of a network path. Virtual time 0 is the start of the experiment's first action.
struct PathProfile {
    /// The distribution of the queueing delay added to each datagram. Delays are independent, so
    /// that datagrams can overtake each other.
    enum class Jitter : std::uint8_t {
        None,
        Exponential, ///< of mean `jitterScale`
        Pareto,      ///< of the second kind (Lomax), shape 3, mean jitterScale / 2: heavy-tailed
        Uniform,     ///< between -jitterScale and +jitterScale; delay is the mean
    };
    /// The Gilbert-Elliott loss model: in the bad state all datagrams are lost. The chain steps
    /// every 10 ms, so these are probabilities per datagram of a stream of 100 per second.
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
    double reordering = 0.0; ///< fraction of datagrams delayed further by heldUp
    Duration heldUp{};
    double bitsPerSecond = 0.0; ///< 0 for no bottleneck
    std::size_t queueBytes = 32768;
    Duration stepAt = Duration::max();
    Duration stepBy{}; ///< added to the delay from stepAt on
    Duration cutFrom = Duration::max();
    Duration cutFor{}; ///< duration of a total loss from cutFrom on
    std::shared_ptr<const std::vector<TracePoint>>
        trace{}; ///< repeats; shared by all links of a run
};

/// Half of a path: two in series have the path's delay, loss and so on. Each half has the full
/// bottleneck.
[[nodiscard]] PathProfile halfOf(const PathProfile& path);

/// A path in virtual time. The delay or loss of a datagram is a function of the seed, of its
/// sending time and of the number of datagrams sent before at that same time, so it can also be
/// evaluated for a hypothetical datagram.
class VirtualLink
{
public:
    VirtualLink(PathProfile path, std::uint64_t seed);

    /// The arrival times of a datagram: none if it is lost, two if it is duplicated.
    struct Arrivals {
        std::size_t count = 0;
        std::array<Duration, 2> at{};
    };
    [[nodiscard]] Arrivals send(std::size_t bytes, Duration now);

    /// The delay of the first datagram sent at `now`, without the queue of the bottleneck;
    /// std::nullopt if it is lost.
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
