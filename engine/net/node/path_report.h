#pragma once

#include "engine/core/ids.h"
#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/connection/peer_traffic.h"
#include "engine/sync/strategies/probe_trigger.h"

#include <optional>
#include <vector>

namespace carina
{

/// What a participant sends to the host.
struct TrafficReport {
    double bytesPerSecond = 0.0;
    double samplesPerSecond = 0.0;
    std::uint64_t facts = 0;   ///< of its proposals, since it came in
    std::uint64_t refused = 0; ///< proposals, samples and datagrams, since it came in
};

/// Measurements of the path to another participant; an unknown value is nothing.
struct PathReport {
    ParticipantId peer;
    std::optional<Duration> roundTrip{};       ///< the newest
    std::vector<Duration> delays{};            ///< H_p: one-way delays, the newest last
    std::optional<Duration> meanDelay{};       ///< h_mean of H_p
    std::optional<Duration> sigma{};           ///< of H_p
    std::optional<double> probesPerSecond{};   ///< gamma_0 that results from them
    std::optional<Duration> clockOffset{};     ///< session time less the participant's local time
    std::optional<Duration> clockError{};      ///< standard error of the offset
    std::optional<Duration> clockErrorBound{}; ///< upper bound of the offset's error
    std::optional<ExternalVerdict> external{}; ///< of clocks disciplined from outside, if both have
    std::optional<double> loss{};              ///< 0 to 1, of the datagrams from this participant
    std::optional<TrafficReport> traffic{};    ///< at the host
    /// Whether delays and gamma_0 are those that the session's strategy goes by, and not those of
    /// the session clock.
    bool isOfStrategy = false;
};

/// A report without clock and traffic.
///
/// @param clocks by which the session clock probes the path
/// @param strategys by which the session's strategy does, nullptr where it does not; reported once
///                  it has a delay
[[nodiscard]] PathReport reportPath(ParticipantId peer, const PeerLink& link,
                                    const ProbeTrigger& clocks, const ProbeTrigger* strategys);

[[nodiscard]] TrafficReport reportTraffic(const PeerTraffic& traffic, LocalTime now);

} // namespace carina
