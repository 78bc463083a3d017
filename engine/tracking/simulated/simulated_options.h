#pragma once

#include "engine/tracking/simulated/simulated_tracker.h"

#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// What a person chooses of a simulated tracker, by words or in a window.
struct SimulatedOptions {
    static constexpr double kSlowest_Hz = 1.0;
    static constexpr double kFastest_Hz = 1000.0;
    static constexpr double kMostDropouts_percent = 90.0;

    double rate_Hz = 60.0;          ///< exposures a second
    double dropouts_percent = 0.0;  ///< of the exposures, that are not delivered
    std::vector<ToolRole> hidden{}; ///< tools that are hidden for two seconds of every ten
    std::vector<ToolRole> partly{}; ///< tools of which half of the markers are, likewise
    bool laryngoscope = false;      ///< there is one, too

    friend bool operator==(const SimulatedOptions&, const SimulatedOptions&) = default;
};

/// The options that words say, separated by commas:
///
///     rate=HZ           exposures a second, 1 to 1000; 60 unless said
///     hidden=TOOL       this tool is hidden for two seconds of every ten
///     partly=TOOL       half of its markers are, likewise
///     dropouts=PERCENT  of the exposures, 0 to 90, are not delivered
///     with=laryngoscope there is a laryngoscope, too, by which the larynx is shown
///
/// such as "rate=30,hidden=tube,dropouts=5". TOOL is the word of a role (toolRoleWord); hidden and
/// partly may be there for several tools.
///
/// @returns WrongOption, which names the fault and what there is.
[[nodiscard]] Result<SimulatedOptions> simulatedOptions(std::string_view words);

/// The words that say these options, and nothing that is so without being said; empty where nothing
/// is left.
[[nodiscard]] std::string simulatedWords(const SimulatedOptions& options);

/// The settings of the tracker that the words choose. @returns the errors of simulatedOptions.
[[nodiscard]] Result<SimulatedTrackerSettings> readSimulatedOptions(std::string_view words);

/// When and for how long a tool is hidden.
inline constexpr Duration kHiddenFrom = std::chrono::seconds{3};
inline constexpr Duration kHiddenFor = std::chrono::seconds{2};
inline constexpr Duration kHiddenEvery = std::chrono::seconds{10};

} // namespace carina
