#pragma once

#include "engine/sync/clock/clock_mapping.h"
#include "engine/sync/strategies/probe_trigger.h"

#include <deque>
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

/// Where the session clock stands and how fast it runs, fitted to many probes.
///
/// Each probe, sent at t0, at the host from t1 to t2 and back at t3, gives (Cristian 1989, as in
/// NTP)
///
///     offset = ((t1 - t0) + (t2 - t3)) / 2      round trip = (t3 - t0) - (t2 - t1)
///
/// and the true offset lies within half the round trip of that, whatever the path does. Queues only
/// ever lengthen a path, so the probes with short round trips are believed: the fit is the line
///
///     offset(t) = a + b (t - t_mean)      with weights  exp(-2 (rtt - rtt_min) / s)
///
/// with s the mean of rtt - rtt_min, over the last kWindow probes within kWindowTime. The skew b is
/// held to 0 with kSkewPrior as far as the scatter of the probes leaves it undetermined, so that a
/// short window does not make one up. The clock works towards the line at 500 ppm and is never set
/// once it is live, except onto a host that is further off than kLargestSlew after a flush.
///
/// Three delays in a row beyond 4 sigma of the history are another route: the window is flushed,
/// and probes are wanted quickly until it is filled anew.
class FittedClock
{
public:
    enum class State : std::uint8_t { Acquiring, Locked, Holdover };

    static constexpr std::size_t kProbesToSet = 10;
    static constexpr std::size_t kWindow = 300;
    static constexpr Duration kWindowTime = std::chrono::seconds{30};
    static constexpr Duration kLargestSlew = std::chrono::milliseconds{50};
    static constexpr int kOutsideInARow = 3;
    static constexpr int kSigmasToFlush = 4;
    /// Standard deviation of the skew of quartz clocks.
    static constexpr double kSkewPrior = 100e-6;
    static constexpr double kLargestSkew = 500e-6;
    /// Without a probe for so long the clock goes on by itself.
    static constexpr Duration kHoldoverAfter = std::chrono::seconds{3};
    /// How the uncertainty grows then.
    static constexpr double kHoldoverGrowth = 1e-6;

    /// A probe that claims a negative round trip is ignored.
    void addProbe(const ClockProbe& probe);
    /// The path or the host may be another one: gathers probes anew. The clock runs on meanwhile.
    void reacquire();

    /// Nothing until the clock is first set.
    [[nodiscard]] const std::optional<ClockMapping>& mapping() const { return m_mapping; }
    /// Probes are wanted quickly.
    [[nodiscard]] bool isAcquiring() const { return m_window.size() < kProbesToSet; }
    [[nodiscard]] State stateAt(LocalTime t) const;
    /// Between probes of a node that sends nothing else.
    [[nodiscard]] Duration idleInterval() const { return m_trigger.interval(); }
    [[nodiscard]] const ProbeTrigger& trigger() const { return m_trigger; }

    /// Session seconds per local second, less 1, as fitted.
    [[nodiscard]] double skew() const { return m_fit.skew; }
    /// Standard error of the session time, seconds: of the fit, at most half the shortest round
    /// trip; what is still to be worked off; and kHoldoverGrowth of the time without probes. @pre
    /// mapping()
    [[nodiscard]] double uncertainty(LocalTime t) const;
    /// Half the shortest round trip, and what is still to be worked off: no path, however lopsided,
    /// makes the error larger. @pre mapping()
    [[nodiscard]] Duration bound(LocalTime t) const;

private:
    struct Probe {
        LocalTime at; ///< the middle of the exchange
        Duration offset;
        Duration roundTrip;
    };
    struct Fit {
        double offset = 0.0; ///< seconds when the last probe came, less that of the oldest probe
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
