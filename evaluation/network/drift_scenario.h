#pragma once

#include "engine/core/result.h"
#include "evaluation/network/virtual_link.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// How the views of an experiment are drawn.
struct ViewFrames {
    /// Frames a second; 0 for a view that is drawn at any time it is looked at. A view shows its
    /// newest frame, which is drawn as of the time at which it begins.
    double rate = 0.0;
    /// Each display runs by itself: its phase is any, and its rate is off by up to this share,
    /// drawn from a uniform distribution.
    double rateError = 0.0;
};

/// The frames of one display.
struct DisplayFrames {
    Duration interval{}; ///< 0 for a view that is drawn at any time it is looked at
    Duration first{};    ///< when one begins, at or before time 0
};

/// Those of some displays, drawn by the seed.
[[nodiscard]] std::vector<DisplayFrames> displaysOf(const ViewFrames& frames, std::size_t displays,
                                                    std::uint32_t seed);

/// A network path, the clock errors of its participants and how their views are drawn.
struct DriftScenario {
    std::string name;
    PathProfile forward;  ///< from the actor to a viewer
    PathProfile backward; ///< from a viewer to the actor
    /// Largest clock offset from the host; offsets are drawn from a uniform distribution.
    Duration clockOffset = std::chrono::milliseconds{100};
    /// Largest clock skew, faster or slower, drawn likewise.
    double clockSkew = 50e-6;
    /// All clocks have the largest offset and skew, alternately fast and slow.
    bool areClocksAtLimits = false;
    /// Largest error of the clocks that every program has beside its own, disciplined from outside:
    /// constant, drawn from a uniform distribution. Nothing: there are none.
    std::optional<Duration> externalClocks{};
    ViewFrames frames{};
};

/// The names of the built-in scenarios.
[[nodiscard]] std::vector<std::string_view> scenarioNames();

/// A built-in scenario by its name, else the delay trace in a file of that name: lines "t_ms
/// delay_ms" with increasing times; a delay of "x" means lost; # starts a comment. The trace
/// applies to both directions and repeats.
/// @returns FileNotFound if there is neither; FileEmpty; FileMalformed, naming the line.
[[nodiscard]] Result<DriftScenario> findScenario(const std::string& nameOrFile);

} // namespace carina
