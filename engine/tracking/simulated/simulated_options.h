#pragma once

#include "engine/tracking/simulated/simulated_tracker.h"

#include <string_view>

namespace carina
{

/// The settings of a simulated tracker that a person names, separated by commas:
///
///     rate=HZ           exposures a second, 1 to 1000; 60 unless said
///     hidden=TOOL       this tool is hidden for two seconds of every ten
///     partly=TOOL       half of its markers are, likewise
///     dropouts=PERCENT  of the exposures, 0 to 90, are not delivered
///
/// such as "rate=30,hidden=tube,dropouts=5". TOOL is the word of a role (toolRoleWord); hidden and
/// partly may be there for several tools.
///
/// @returns WrongOption, which names the fault and what there is.
[[nodiscard]] Result<SimulatedTrackerSettings> readSimulatedOptions(std::string_view words);

/// When and for how long a tool is hidden.
inline constexpr Duration kHiddenFrom = std::chrono::seconds{3};
inline constexpr Duration kHiddenFor = std::chrono::seconds{2};
inline constexpr Duration kHiddenEvery = std::chrono::seconds{10};

} // namespace carina
