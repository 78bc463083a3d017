#pragma once

#include "engine/core/result.h"
#include "evaluation/network/virtual_link.h"

#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// A network and the clocks at its ends.
struct DriftScenario {
    std::string name;
    PathProfile forward;  ///< from the actor to a viewer
    PathProfile backward; ///< from a viewer to the actor
    /// Clocks are off the host's by up to this, drawn evenly.
    Duration clockOffset = std::chrono::milliseconds{100};
    /// And run faster or slower by up to this.
    double clockSkew = 50e-6;
    /// All clocks are off by just that much, in turn fast and slow.
    bool areClocksAtLimits = false;
};

/// The names of those that are built in.
[[nodiscard]] std::vector<std::string_view> scenarioNames();

/// A built-in scenario by its name, else the trace in a file of that name: lines "t_ms delay_ms",
/// times rising, x for the delay of what is lost, # begins a comment. A trace is the delay of
/// either direction and repeats.
/// @returns FileNotFound for a name that is neither; FileEmpty; FileMalformed, naming the line.
[[nodiscard]] Result<DriftScenario> findScenario(const std::string& nameOrFile);

} // namespace carina
