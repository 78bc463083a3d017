#pragma once

#include <algorithm>
#include <vector>

namespace carina
{

/// One repetition of a benchmark.
struct Repetition {
    double perCall_ns = 0.0; ///< mean of its calls
    double calls = 0.0;
};

/// What all repetitions of a benchmark gave.
struct RepeatedTimes {
    double mean_ns = 0.0;   ///< of all calls, those that a busy computer delayed included
    double median_ns = 0.0; ///< of the repetitions; a few delayed ones do not change it
};

/// @pre there is one repetition at least, and each has calls.
[[nodiscard]] inline RepeatedTimes timesOf(std::vector<Repetition> repetitions)
{
    double all_ns = 0.0;
    double calls = 0.0;
    for (const Repetition& each : repetitions) {
        all_ns += each.perCall_ns * each.calls;
        calls += each.calls;
    }
    std::ranges::sort(repetitions, {}, &Repetition::perCall_ns);
    return {.mean_ns = all_ns / calls, .median_ns = repetitions[repetitions.size() / 2].perCall_ns};
}

} // namespace carina
