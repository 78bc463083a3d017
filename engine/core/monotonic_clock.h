#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// The one reading of time in a Carina process: CLOCK_MONOTONIC.
///
/// Everything deterministic is handed a time instead of calling this.
[[nodiscard]] LocalTime monotonicNow();

} // namespace carina
