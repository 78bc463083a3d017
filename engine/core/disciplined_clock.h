#pragma once

#include "engine/core/external_time.h"
#include "engine/core/result.h"

#include <optional>

namespace carina
{

/// What the kernel says of the discipline of the system's clock (adjtimex).
struct ClockDiscipline {
    bool isSynchronised = false; ///< by whoever disciplines it: no STA_UNSYNC
    Duration estimatedError{};   ///< esterror; 0, or the kernel's 16 s, where nobody says it
    Duration largestError{};     ///< maxerror
};

/// The standard error of such a clock; nothing for one that is not disciplined, or of which nobody
/// says how well: chrony and ntpd do, from PTP too, systemd-timesyncd and linuxptp do not.
///
/// A time service that has ended leaves esterror as it was, while the kernel raises maxerror by
/// 500 ppm from the last time that it was set (second_overflow, MAXFREQ in linux/timex.h). So the
/// clock has been alone for maxerror / 500 ppm at most, and runs off meanwhile by some 1 ppm, which
/// is what temperature changes of a quartz whose frequency was corrected:
///
///     error = esterror + maxerror / 500
///
/// From a maxerror of 2 s on, after an hour alone, nobody disciplines it: the services look again
/// every 1024 s at the latest.
[[nodiscard]] std::optional<Duration> statedError(const ClockDiscipline& discipline);

/// A disciplined clock in place of the system's, for tests: programs of one machine, whose system
/// clock is the same, then have clocks that differ as those of several machines.
struct InjectedClock {
    Duration offset{}; ///< from the system's clock, which counts as the truth
    Duration error{};  ///< standard error that it states; 0: it is not disciplined

    friend bool operator==(const InjectedClock&, const InjectedClock&) = default;
};

/// Parses both in milliseconds; nothing where the error is nullptr: the system's clock.
/// @returns OutOfRange as millisecondsFrom does, and for an error below 0.
[[nodiscard]] Result<std::optional<InjectedClock>> injectedClockFrom(const char* offsetMs,
                                                                     const char* errorMs);

/// The injected clock less monotonicNow(); nothing where it is not disciplined.
[[nodiscard]] std::optional<ExternalTime> readInjectedClock(const InjectedClock& clock);

/// The system's clock (CLOCK_REALTIME) less monotonicNow(), with its statedError(); nothing where
/// there is none. With the environment variable CARINA_EXTERNAL_CLOCK_ERROR_MS, and
/// CARINA_EXTERNAL_CLOCK_OFFSET_MS, which is 0 unless set, the injected clock in its place.
///
/// @pre the two variables, where they are set, are valid for injectedClockFrom.
[[nodiscard]] std::optional<ExternalTime> readDisciplinedClock();

} // namespace carina
