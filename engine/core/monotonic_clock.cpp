#include "engine/core/monotonic_clock.h"

#include <ctime>

namespace carina
{

LocalTime monotonicNow()
{
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return LocalTime{std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec}};
}

} // namespace carina
