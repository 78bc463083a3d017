#include "engine/core/monotonic_clock.h"

#include "engine/core/clock_shift.h"
#include "engine/core/expects.h"

#include <cstdlib>
#include <ctime>

namespace carina
{
namespace
{

const ClockShift& shiftOfThisProcess()
{
    static const ClockShift shift = [] {
        const auto read =
            clockShiftFrom(std::getenv("CARINA_CLOCK_OFFSET_MS"), std::getenv("CARINA_CLOCK_PPM"));
        CARINA_EXPECTS(read.has_value());
        return *read;
    }();
    return shift;
}

} // namespace

LocalTime monotonicNow()
{
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return shiftOfThisProcess().process(
        LocalTime{std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec}});
}

LocalTime machineTime(LocalTime t) { return shiftOfThisProcess().machine(t); }

} // namespace carina
