#pragma once

#include "engine/core/external_time.h"

#include <optional>

namespace carina
{

/// What the kernel says of the discipline of the system's clock (adjtimex).
struct ClockDiscipline {
    bool isSynchronised = false; ///< by whoever disciplines it: no STA_UNSYNC
    Duration estimatedError{};   ///< esterror; 0 where nobody says it
    Duration largestError{};     ///< maxerror
};

/// The standard error of such a clock; nothing for one that is not disciplined, of which nobody
/// says how well, or whose error may be 16 s, which the kernel takes for lost.
[[nodiscard]] std::optional<Duration> statedError(const ClockDiscipline& discipline);

/// The system's clock (CLOCK_REALTIME) less monotonicNow(), with its statedError(); nothing where
/// there is none.
[[nodiscard]] std::optional<ExternalTime> readDisciplinedClock();

} // namespace carina
