#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

namespace carina
{

/// A deliberate error of a process's clock relative to its machine's clock, for tests:
///
///     t_process = t_machine + offset + skew t_machine
struct ClockShift {
    /// The largest absolute offset and skew: 24 h and 1000 ppm.
    static constexpr Duration kLargestOffset = std::chrono::hours{24};
    static constexpr double kLargestSkew = 1e-3;

    Duration offset{};
    double skew = 0.0;

    /// t_process of a t_machine.
    [[nodiscard]] LocalTime process(LocalTime machine) const;
    /// t_machine of a t_process: the inverse of process(), to a nanosecond.
    [[nodiscard]] LocalTime machine(LocalTime process) const;
};

/// Parses a decimal number of milliseconds; nullptr means 0.
/// @returns OutOfRange for a text that is not a number, or one beyond +-kLargestOffset.
[[nodiscard]] Result<Duration> millisecondsFrom(const char* text);

/// Parses an offset in milliseconds and a skew in ppm, both decimal numbers; nullptr means 0.
/// @returns OutOfRange for a text that is not a number, or a number beyond the limits above.
[[nodiscard]] Result<ClockShift> clockShiftFrom(const char* offsetMs, const char* ppm);

} // namespace carina
