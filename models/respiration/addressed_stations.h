#pragma once

#include "engine/session/session_state.h"

#include <vector>

namespace carina
{

/// The stations that a person's change is for.
struct AddressedStations {
    StationId shown;  ///< whose values are displayed
    bool all = false; ///< a change is for all open stations

    /// The station of the proposal.
    [[nodiscard]] StationId target() const { return all ? kAllStations : shown; }
};

/// The open stations that a proposal with this target changes.
[[nodiscard]] inline std::vector<StationId> stationsOf(const SessionState& state, StationId target)
{
    std::vector<StationId> ids;
    for (const auto& [id, station] : state.stations())
        if (!station.closed && (target == id || target == kAllStations))
            ids.push_back(id);
    return ids;
}

} // namespace carina
