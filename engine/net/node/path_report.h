#pragma once

#include "engine/core/ids.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/strategies/probe_trigger.h"

#include <optional>
#include <vector>

namespace carina
{

/// The path to another participant, measured; what is not known yet is nothing.
struct PathReport {
    ParticipantId peer;
    std::optional<Duration> roundTrip{};       ///< the newest
    std::vector<Duration> delays{};            ///< H_p: one way, the newest last
    std::optional<Duration> meanDelay{};       ///< h_mean of them
    std::optional<Duration> sigma{};           ///< of them
    std::optional<double> probesPerSecond{};   ///< gamma_0 that they call for
    std::optional<Duration> clockOffset{};     ///< session time less the participant's local time
    std::optional<Duration> clockError{};      ///< standard error of the offset
    std::optional<Duration> clockErrorBound{}; ///< nothing makes the offset's error larger
    std::optional<double> loss{};              ///< 0 to 1, of the datagrams from there
};

/// All but the clock.
[[nodiscard]] PathReport reportPath(ParticipantId peer, const PeerLink& link,
                                    const ProbeTrigger& trigger);

} // namespace carina
