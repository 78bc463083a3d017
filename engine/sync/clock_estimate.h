#pragma once

#include "engine/core/session_time.h"

#include <optional>

namespace carina
{

/// One exchange with the session host, whose clock is the session's.
struct ClockProbe {
    LocalTime sent;           ///< by this node
    SessionTime hostReceived; ///< at the host
    SessionTime hostSent;     ///< by the host, in answer
    LocalTime received;       ///< by this node
};

/// Local time to session time. A value: copied to whoever needs the time.
///
/// Session time is local time and an offset that grows with the skew of the two clocks. A
/// correction is spread: it is worked off at 1/kSlewDivisor, so that session time never jumps and
/// never runs backwards.
class ClockMapping
{
public:
    /// 500 ppm.
    static constexpr int kSlewDivisor = 2000;

    /// @param skew seconds of session time per second of local time, less 1
    ClockMapping(LocalTime start, Duration offset, double skew = 0.0)
        : m_start{start}, m_offset{offset}, m_skew{skew}
    {
    }

    [[nodiscard]] SessionTime at(LocalTime t) const;
    /// Works from `start` on towards what would be `offset` at `start`, and from there on has
    /// `skew`.
    void slewTo(Duration offset, LocalTime start, double skew = 0.0);
    /// Of the correction, at local time t.
    [[nodiscard]] Duration toGo(LocalTime t) const;

private:
    [[nodiscard]] Duration offsetAt(LocalTime t) const;

    LocalTime m_start;
    Duration m_offset; // session time less local time, at m_start
    double m_skew;
    Duration m_correction{}; // to be added to it from there on
};

/// Where the session clock stands, estimated from probes (Cristian 1989, as in NTP):
///
///     offset = ((t1 - t0) + (t2 - t3)) / 2      round trip = (t3 - t0) - (t2 - t1)
///
/// The true offset lies within half the round trip of the estimate, whatever the path does. So the
/// probe with the shortest round trip is believed, until a newer one is better than it has become:
/// its bound grows with age by kSkewAllowance, for two clocks do not run alike.
class ClockEstimate
{
public:
    /// So many probes are seen before the clock is set: one of them may have met a queue.
    static constexpr int kProbesToSet = 5;
    /// A clock found further off than this when the host has come back is set anew.
    static constexpr Duration kLargestSlew = std::chrono::milliseconds{50};
    /// 1 / 100 ppm.
    static constexpr int kSkewAllowanceDivisor = 10'000;

    /// A probe that claims a negative round trip is ignored.
    void addProbe(const ClockProbe& probe);

    /// Nothing until the clock is first set.
    [[nodiscard]] const std::optional<ClockMapping>& mapping() const { return m_mapping; }
    /// Probes are wanted quickly.
    [[nodiscard]] bool isAcquiring() const { return m_probes < kProbesToSet; }
    /// The bound of the estimate's error at local time t. @pre mapping()
    [[nodiscard]] Duration uncertainty(LocalTime t) const;

    /// The path or the host may be another one: gathers probes anew. The clock runs on meanwhile.
    void reacquire() { m_probes = 0; }

private:
    struct Measurement {
        Duration offset;
        Duration halfRoundTrip;
        LocalTime received;
    };
    [[nodiscard]] static Duration boundOf(const Measurement& measured, LocalTime t);

    void adopt(LocalTime now);

    int m_probes = 0;
    std::optional<Measurement> m_best;
    std::optional<ClockMapping> m_mapping;
};

} // namespace carina
