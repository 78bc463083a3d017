#include "engine/core/disciplined_clock.h"

#include "engine/core/monotonic_clock.h"

#include <sys/timex.h>

#include <algorithm>
#include <ctime>

namespace carina
{
namespace
{

using std::chrono::microseconds;

constexpr Duration kLost = std::chrono::seconds{16};
/// What the kernel counts in.
constexpr Duration kFinestError = microseconds{1};

ClockDiscipline disciplineOfSystem()
{
    timex state{}; // no mode: it is only read
    const int result = ::adjtimex(&state);
    return {result != -1 && result != TIME_ERROR && (state.status & STA_UNSYNC) == 0,
            microseconds{state.esterror}, microseconds{state.maxerror}};
}

} // namespace

std::optional<Duration> statedError(const ClockDiscipline& discipline)
{
    if (!discipline.isSynchronised || discipline.estimatedError <= Duration{}
        || discipline.largestError >= kLost || discipline.estimatedError >= kLost)
        return std::nullopt;
    return std::max(discipline.estimatedError, kFinestError);
}

std::optional<ExternalTime> readDisciplinedClock()
{
    const auto error = statedError(disciplineOfSystem());
    if (!error)
        return std::nullopt;
    const LocalTime before = monotonicNow();
    timespec system{};
    clock_gettime(CLOCK_REALTIME, &system);
    const Duration whileReading = monotonicNow() - before;
    const Duration read =
        std::chrono::seconds{system.tv_sec} + std::chrono::nanoseconds{system.tv_nsec};
    return ExternalTime{read - (before + whileReading / 2).time_since_epoch(),
                        *error + whileReading / 2};
}

} // namespace carina
