#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

namespace carina
{

/// How a process's clock is off its machine's on purpose:
///
///     t_process = t_machine + offset + skew t_machine
struct ClockShift {
    /// A day and 1000 ppm, either way.
    static constexpr Duration kLargestOffset = std::chrono::hours{24};
    static constexpr double kLargestSkew = 1e-3;

    Duration offset{};
    double skew = 0.0;

    [[nodiscard]] LocalTime process(LocalTime machine) const;
    /// The inverse, to a nanosecond.
    [[nodiscard]] LocalTime machine(LocalTime process) const;
};

/// Reads a shift from decimal numbers; nullptr is none.
/// @returns OutOfRange for what is no number or beyond the largest.
[[nodiscard]] Result<ClockShift> clockShiftFrom(const char* offsetMs, const char* ppm);

} // namespace carina
