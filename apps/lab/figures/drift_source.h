#pragma once

#include "engine/core/result.h"
#include "evaluation/drift/drift_experiment.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace carina::lab
{

/// Where the numbers of the figures come from, and of what there are some.
struct DriftSource {
    std::vector<std::string_view> byAction{};       ///< strategies
    std::vector<std::string_view> byParticipants{}; ///< strategies
    std::vector<std::string_view> byDelay{};        ///< strategies
    std::vector<double> speeds{};                   ///< by participants: deg/s, and mm/s
    std::string network{};                          ///< added to its name
    std::function<Result<DriftFigures>(const DriftSettings&)> run{};
};

/// Virtual time, all strategies; each number is the mean of so many runs.
[[nodiscard]] DriftSource virtualDrift(int seeds);

/// Programs of their own in real time, over relays (runLiveDrift), at full speed: these strategies.
/// One run each, with so long for the clocks before it.
[[nodiscard]] DriftSource liveDrift(const std::vector<std::string_view>& strategies,
                                    Duration warmUp);

/// The names of all strategies.
[[nodiscard]] std::vector<std::string_view> allStrategies();

} // namespace carina::lab
