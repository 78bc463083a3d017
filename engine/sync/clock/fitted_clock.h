#pragma once

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
///     offset(t) = a + b (t - t_mean)      with weights  exp(-2 (rtt - rtt_min) / s)
///
/// with s the mean of rtt - rtt_min, over the last kWindow probes within kWindowTime. A prior of
/// standard deviation kSkewPrior keeps the skew b near 0 as far as the scatter of the probes leaves
/// it undetermined, as in a short window. The clock is slewed towards the line at 500 ppm. Once
/// live it is set only where it is off by more than kLargestSlew.
///
/// Three one-way delays in a row beyond 4 sigma of the history are taken for a change of route: the
/// window is flushed, and probes are requested at a high rate until kProbesToSet arrived.
class FittedClock
{
public:
    enum class State : std::uint8_t { Acquiring, Locked, Holdover };

    static constexpr std::size_t kProbesToSet = 10; ///< probes after which the clock is set
    static constexpr std::size_t kWindow = 300;
    static constexpr Duration kWindowTime = std::chrono::seconds{30};
    static constexpr Duration kLargestSlew = std::chrono::milliseconds{50};
    static constexpr int kOutsideInARow = 3;
    static constexpr int kSigmasToFlush = 4;
    /// Standard deviation of the skew of quartz clocks.
    static constexpr double kSkewPrior = 100e-6;
    static constexpr double kLargestSkew = 500e-6;
    /// Time without a probe after which the state is Holdover: the clock continues by the last fit.
    static constexpr Duration kHoldoverAfter = std::chrono::seconds{3};
    /// Growth of the uncertainty in holdover, seconds per second.
    static constexpr double kHoldoverGrowth = 1e-6;

    /// Adds a probe. One with a negative round trip is ignored.
    void addProbe(const ClockProbe& probe);
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
    /// Standard error of the session time, seconds: of the fit, at most half the shortest round
    /// trip; plus the correction still to be slewed; plus kHoldoverGrowth times the duration of a
    /// holdover. @pre mapping()
    [[nodiscard]] double uncertainty(LocalTime t) const;
    /// Upper bound of the error: half the shortest round trip, plus the correction still to be
    /// slewed. It holds for any asymmetry of the path. @pre mapping()
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
    void adopt(LocalTime now);

    std::deque<Probe> m_window; // the newest last
    ProbeTrigger m_trigger{kIdleProbes};
    int m_outsideInARow = 0;
    Fit m_fit;
    Duration m_bound{};
    LocalTime m_lastProbe{};
    std::optional<ClockMapping> m_mapping;
};

} // namespace carina
