#include "engine/core/disciplined_clock.h"

#include "engine/core/clock_shift.h"
#include "engine/core/expects.h"
#include "engine/core/monotonic_clock.h"

#include <sys/timex.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

namespace carina
{
namespace
{

using std::chrono::microseconds;

/// The esterror of a clock of which nobody said how well it is disciplined.
constexpr Duration kNotStated = std::chrono::seconds{16};
/// The maxerror of a clock that was alone for 4000 s.
constexpr Duration kAlone = std::chrono::seconds{2};
/// By how much less a corrected clock runs off than maxerror grows: 1 ppm beside 500.
constexpr int kGrowthToDrift = 500;
/// What the kernel counts in.
constexpr Duration kFinestError = microseconds{1};

ClockDiscipline disciplineOfSystem()
{
    timex state{}; // no mode: it is only read
    const int result = ::adjtimex(&state);
    return {result != -1 && result != TIME_ERROR && (state.status & STA_UNSYNC) == 0,
            microseconds{state.esterror}, microseconds{state.maxerror}};
}

/// CLOCK_REALTIME less monotonicNow(), with how long it took to read as its error.
ExternalTime readSystemClock()
{
    const LocalTime before = monotonicNow();
    timespec system{};
    clock_gettime(CLOCK_REALTIME, &system);
    const Duration whileReading = monotonicNow() - before;
    const Duration read =
        std::chrono::seconds{system.tv_sec} + std::chrono::nanoseconds{system.tv_nsec};
    return {read - (before + whileReading / 2).time_since_epoch(), whileReading / 2};
}

const std::optional<InjectedClock>& injectedIntoThisProcess()
{
    static const std::optional<InjectedClock> injected = [] {
        const auto read = injectedClockFrom(std::getenv("CARINA_EXTERNAL_CLOCK_OFFSET_MS"),
                                            std::getenv("CARINA_EXTERNAL_CLOCK_ERROR_MS"));
        CARINA_EXPECTS(read.has_value());
        return *read;
    }();
    return injected;
}

} // namespace

std::optional<Duration> statedError(const ClockDiscipline& discipline)
{
    if (!discipline.isSynchronised || discipline.estimatedError <= Duration{}
        || discipline.largestError >= kAlone || discipline.estimatedError >= kNotStated)
        return std::nullopt;
    return std::max(discipline.estimatedError + discipline.largestError / kGrowthToDrift,
                    kFinestError);
}

Result<std::optional<InjectedClock>> injectedClockFrom(const char* offsetMs, const char* errorMs)
{
    if (!errorMs)
        return std::nullopt;
    const auto offset = millisecondsFrom(offsetMs);
    const auto error = millisecondsFrom(errorMs);
    if (!offset || !error)
        return tl::unexpected(offset ? error.error() : offset.error());
    if (*error < Duration{})
        return fail(Errc::OutOfRange, errorMs);
    return InjectedClock{*offset, *error};
}

std::optional<ExternalTime> readInjectedClock(const InjectedClock& clock)
{
    if (clock.error == Duration{})
        return std::nullopt;
    const ExternalTime system = readSystemClock();
    return ExternalTime{system.offset + clock.offset, clock.error + system.error};
}

std::optional<ExternalTime> readDisciplinedClock()
{
    if (const auto& injected = injectedIntoThisProcess())
        return readInjectedClock(*injected);
    const auto error = statedError(disciplineOfSystem());
    if (!error)
        return std::nullopt;
    const ExternalTime system = readSystemClock();
    return ExternalTime{system.offset, *error + system.error};
}

} // namespace carina
