#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// The one reading of time in a Carina process: CLOCK_MONOTONIC, shifted for tests by what
/// CARINA_CLOCK_OFFSET_MS and CARINA_CLOCK_PPM say (see ClockShift), so that several processes of
/// one machine have clocks as different as those of several machines.
///
/// Everything deterministic is handed a time instead of calling this.
///
/// @pre the two variables, where they are set, are numbers as clockShiftFrom wants them.
[[nodiscard]] LocalTime monotonicNow();

/// The machine's CLOCK_MONOTONIC at a time of this process's clock: what a log says that is
/// compared with those of other processes.
[[nodiscard]] LocalTime machineTime(LocalTime t);

} // namespace carina
