#pragma once

#include "engine/sync/strategies/delay_history.h"

namespace carina
{

/// The highest rate at which one participant may probe the path to another, per second.
inline constexpr double kFastestProbes = 20.0;

/// How often a path is probed: gamma_0 probes a second, by the adaptive trigger of the Adaptive
/// Synchronization Algorithm (Hamza-Lup et al. 2004).
///
/// While the history fills, gamma_0 keeps its start value. Then each new delay h_0 within h_mean +-
/// sigma lowers it by 1 per second and each one outside raises it by 1. What the paper leaves open
/// is decided here: gamma_0 stays within [lowest, highest], and a delay on the boundary is inside,
/// so that sigma = 0 (all delays equal) lowers it.
class ProbeTrigger
{
public:
    struct Rule {
        bool isAdaptive = true;
        double start = 1.0;                            ///< per second
        double lowest = 1.0;                           ///< per second
        double highest = kFastestProbes;               ///< per second
        Duration sigmaFloor{};                         ///< a smaller sigma counts as this
        std::size_t history = DelayHistory::kCapacity; ///< number of delays before it adapts
        std::size_t kept = DelayHistory::kCapacity;    ///< number of delays that are kept
    };

    explicit ProbeTrigger(const Rule& rule) : m_rule{rule}, m_rate{rule.start}, m_history{rule.kept}
    {
    }

    void addDelay(Duration delay);
    /// Discards the delays and returns to the start value.
    void reset();

    /// gamma_0, per second.
    [[nodiscard]] double rate() const { return m_rate; }
    [[nodiscard]] Duration interval() const { return fromSeconds(1.0 / m_rate); }
    [[nodiscard]] const DelayHistory& history() const { return m_history; }
    /// Whether a delay is further than this many sigma from the mean. @pre history().size() > 0
    [[nodiscard]] bool isOutside(Duration delay, int sigmas) const;

private:
    Rule m_rule;
    double m_rate;
    DelayHistory m_history;
};

/// The rule by which an idle node probes its path to the session host.
inline constexpr ProbeTrigger::Rule kIdleProbes{.sigmaFloor = std::chrono::microseconds{100},
                                                .history = 20};

} // namespace carina
