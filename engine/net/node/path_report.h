#pragma once

#include "engine/core/ids.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/strategies/probe_trigger.h"

#include <optional>
#include <vector>

namespace carina
{

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
    std::optional<double> loss{};              ///< 0 to 1, of the datagrams from this participant
};

/// A report without the clock values.
[[nodiscard]] PathReport reportPath(ParticipantId peer, const PeerLink& link,
                                    const ProbeTrigger& trigger);

} // namespace carina
