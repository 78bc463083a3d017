#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// The current time of this process's clock, the only clock that a Carina process reads:
/// CLOCK_MONOTONIC, shifted for tests by the environment variables CARINA_CLOCK_OFFSET_MS and
/// CARINA_CLOCK_PPM (see ClockShift). With these, processes on one machine can have clocks that
/// differ like those of several machines.
///
/// Deterministic code takes the time as an argument instead of calling this.
///
/// @pre the two variables, where they are set, are valid for clockShiftFrom.
[[nodiscard]] LocalTime monotonicNow();

/// Converts a time of this process's clock to the machine's CLOCK_MONOTONIC without the shift, for
/// logs that are compared with those of other processes.
[[nodiscard]] LocalTime machineTime(LocalTime t);

} // namespace carina
