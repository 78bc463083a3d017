#pragma once

#include "bench/repeated_times.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <map>
#include <string>

namespace carina
{

inline constexpr int kRepetitions = 15;

/// Runs several benchmarks alternately, kRepetitions times each and in random order, so that a
/// temporary load of the processor affects all of them.
/// @returns how long one iteration of each took; ends the program if one was not measured.
[[nodiscard]] std::map<std::string, RepeatedTimes>
repeatedTimes(const std::map<std::string, void (*)(benchmark::State&)>& measured);

/// The same, the medians alone, nanoseconds.
[[nodiscard]] std::map<std::string, double>
medianTimes_ns(const std::map<std::string, void (*)(benchmark::State&)>& measured);

} // namespace carina
