#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

#include <optional>
#include <string>
#include <string_view>

namespace carina
{

/// The open station with this name, or with one that looks like it.
[[nodiscard]] std::optional<StationId> openStationNamed(const SessionState& state,
                                                        std::string_view name);
/// The open station with the lowest number; kNoStation where there is none.
[[nodiscard]] StationId firstOpenStation(const SessionState& state);
/// "Station 1, Room 5"
[[nodiscard]] std::string openStationNames(const SessionState& state);

/// The station of the fact that a proposal becomes. A new station gets the next number. Who joins
/// without naming one comes to the station they were at last, if it is open, else to the first.
/// @pre the number of the participant who joins is settled; 0 is new
/// @returns OutOfRange for a new station with a number; StationUnknown where none is open.
[[nodiscard]] Result<StationId> settledStation(const SessionState& state, StationId asked,
                                               const FactBody& body);

/// Whether a fact can be of this station: of an open one, unless it is about none; a change of the
/// patient also of all. @pre settledStation
/// @returns StationUnknown.
[[nodiscard]] Result<void> checkStation(const SessionState& state, StationId station,
                                        const FactBody& body);

/// Whether a station may be added, named so, or closed.
/// @returns StationCount; NameUnclear; StationOccupied with those who are there.
[[nodiscard]] Result<void> checkStations(const SessionState& state, StationId station,
                                         const FactBody& body);

} // namespace carina
