#pragma once

#include "engine/core/external_time.h"
#include "engine/sync/clock/clock_mapping.h"
#include "engine/sync/strategies/probe_trigger.h"

#include <deque>
#include <optional>

namespace carina
{

/// Timestamps of one exchange with the session host, whose clock is the session clock.
struct ClockProbe {
    LocalTime sent;           ///< by this node
    SessionTime hostReceived; ///< at the host
    SessionTime hostSent;     ///< by the host, in answer
    LocalTime received;       ///< by this node
};

/// Standard deviation of the skew of quartz clocks.
inline constexpr double kClockSkewPrior = 100e-6;

/// The session clock less this node's clock, by clocks that are disciplined from outside at both.
struct ExternalOffset {
    LocalTime at;      ///< of this node, when the older of the two readings was made
    Duration offset{}; ///< session time less local time
    Duration error{};  ///< standard error, above 0
};

/// That of a reading at the host, less session time, and one at this node, less its local time. At
/// `now`, of this node, one is fresh and the other `age` old: its clock may have run off by
/// kClockSkewPrior since. The older one dates the offset, so that who reads no more is not kept
/// alive by the other.
[[nodiscard]] ExternalOffset externalOffset(const ExternalTime& host, const ExternalTime& own,
                                            Duration age, LocalTime now);

/// What became of an ExternalOffset.
struct ExternalVerdict {
    /// The external offset less that of the probes; it is half of the path's asymmetry where the
    /// external clocks are right.
    Duration difference{};
    Duration error{};       ///< standard error of the external offset
    bool isRefused = false; ///< it contradicts the round trip
};

/// Offset and skew of the session clock, fitted to many probes.
///
/// Each probe, sent at t0, at the host from t1 to t2 and back at t3, gives (Cristian 1989, as in
/// NTP)
///
///     offset = ((t1 - t0) + (t2 - t3)) / 2      round trip = (t3 - t0) - (t2 - t1)
///
/// and the true offset is within half the round trip of this, however asymmetric the path is.
/// Queues only lengthen a path, so that probes with short round trips are more accurate. The fit is
/// the line
///
///     offset(t) = a + b (t - t_mean)      with weights  exp(-kSteepness (rtt - rtt_min) / s)
///
/// with s the mean of rtt - rtt_min, over the last kWindow probes within kWindowTime. Where queues
/// are exponential, the offset of a probe is off by up to (rtt - rtt_min) / 2, evenly distributed:
/// a steeper weight leaves fewer probes with smaller errors. A prior of
/// standard deviation kSkewPrior keeps the skew b near 0 as far as the scatter of the probes leaves
/// it undetermined, as in a short window. The clock is slewed towards the line at 500 ppm. Once
/// live it is set only where it is off by more than kLargestSlew.
///
/// Clocks that are disciplined from outside at both ends give one measurement more, without the
/// error of an asymmetric path, which no probe can show. The offset of the line can be off by
/// anything up to half the shortest round trip r, so that it has the variance V of an even
/// distribution over it and of the fit; the external one has the variance W of its standard error:
///
///     V = (r/2)^2 / 3 + error^2       offset = line + (external - line) V / (V + W)
///
/// limited to r/2 from the line, beyond which the offset cannot be. An external offset further from
/// the line than r/2 and kErrorsToRefuse standard errors is refused: one of the two clocks is not
/// what it says. One older than kExternalTime has no effect.
///
/// Three one-way delays in a row beyond 4 sigma of the history are taken for a change of route: the
/// window is flushed, and probes are requested at a high rate until kProbesToSet arrived.
class FittedClock
{
public:
    enum class State : std::uint8_t { Acquiring, Locked, Holdover };

    static constexpr std::size_t kProbesToSet = 10; ///< probes after which the clock is set
    static constexpr std::size_t kWindow = 450;
    static constexpr Duration kWindowTime = std::chrono::seconds{45};
    static constexpr double kSteepness = 4.0;
    static constexpr Duration kLargestSlew = std::chrono::milliseconds{50};
    static constexpr int kOutsideInARow = 3;
    static constexpr int kSigmasToFlush = 4;
    static constexpr double kSkewPrior = kClockSkewPrior;
    static constexpr double kLargestSkew = 500e-6;
    /// Time without a probe after which the state is Holdover: the clock continues by the last fit.
    static constexpr Duration kHoldoverAfter = std::chrono::seconds{3};
    /// Growth of the uncertainty in holdover, seconds per second.
    static constexpr double kHoldoverGrowth = 1e-6;

    static constexpr Duration kExternalTime = std::chrono::seconds{10};
    static constexpr int kErrorsToRefuse = 3;

    /// Adds a probe. One with a negative round trip is ignored.
    void addProbe(const ClockProbe& probe);
    /// The newest external offset; it takes effect with the next probe.
    void setExternal(const ExternalOffset& external) { m_external = external; }
    /// Discards the probes, because path or host may have changed. The clock continues meanwhile.
    void reacquire();

    /// Nothing until the clock is first set.
    [[nodiscard]] const std::optional<ClockMapping>& mapping() const { return m_mapping; }
    /// Whether probes are required at a high rate.
    [[nodiscard]] bool isAcquiring() const { return m_window.size() < kProbesToSet; }
    [[nodiscard]] State stateAt(LocalTime t) const;
    /// Interval of probes for a node that sends nothing else.
    [[nodiscard]] Duration idleInterval() const { return m_trigger.interval(); }
    [[nodiscard]] const ProbeTrigger& trigger() const { return m_trigger; }

    /// Session seconds per local second, less 1, as fitted.
    [[nodiscard]] double skew() const { return m_fit.skew; }
    /// What the last probe made of the external offset; nothing where there was none.
    [[nodiscard]] const std::optional<ExternalVerdict>& external() const { return m_verdict; }
    /// Standard error of the session time, seconds: of the fit and the external offset, where one
    /// is used, at most half the shortest round trip; plus the correction still to be slewed; plus
    /// kHoldoverGrowth times the duration of a holdover. @pre mapping()
    [[nodiscard]] double uncertainty(LocalTime t) const;
    /// Upper bound of the error: half the shortest round trip, plus what an external offset moved
    /// the clock by, plus the correction still to be slewed. It holds for any asymmetry of the
    /// path. @pre mapping()
    [[nodiscard]] Duration bound(LocalTime t) const;

private:
    struct Probe {
        LocalTime at; ///< the middle of the exchange
        Duration offset;
        Duration roundTrip;
    };
    struct Fit {
        double offset = 0.0; ///< seconds, at the last probe, less the offset of the oldest probe
        double skew = 0.0;
        double error = 0.0; ///< standard error of the offset, seconds
    };

    [[nodiscard]] bool isOtherRoute(Duration delay);
    [[nodiscard]] Duration shortestRoundTrip() const;
    [[nodiscard]] Fit fit() const;
    /// Judges the external offset and takes it into the fit. @returns the change of the offset
    Duration fuse(LocalTime now, Duration line);
    void adopt(LocalTime now);

    std::deque<Probe> m_window; // the newest last
    ProbeTrigger m_trigger{kIdleProbes};
    int m_outsideInARow = 0;
    Fit m_fit;
    Duration m_bound{};
    std::optional<ExternalOffset> m_external;
    std::optional<ExternalVerdict> m_verdict;
    LocalTime m_lastProbe{};
    std::optional<ClockMapping> m_mapping;
};

} // namespace carina
