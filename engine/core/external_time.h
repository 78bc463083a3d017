#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// A reading of a clock that something outside of the session disciplines, such as NTP or PTP.
struct ExternalTime {
    Duration offset{}; ///< that clock, since 1970, less the clock of the program that reads it
    Duration error{};  ///< standard error of the offset, above 0

    friend bool operator==(const ExternalTime&, const ExternalTime&) = default;
};

} // namespace carina
