#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace carina
{

using Duration = std::chrono::nanoseconds;

/// The clock that all sites of a session share. Only engine/net reads it.
struct SessionClock {
    using rep = Duration::rep;
    using period = Duration::period;
    using duration = Duration;
    using time_point = std::chrono::time_point<SessionClock>;
    static constexpr bool is_steady = true;
};

/// CLOCK_MONOTONIC of one machine.
struct LocalClock {
    using rep = Duration::rep;
    using period = Duration::period;
    using duration = Duration;
    using time_point = std::chrono::time_point<LocalClock>;
    static constexpr bool is_steady = true;
};

/// Nanoseconds on the session clock. A type of its own: it cannot be mixed with LocalTime.
using SessionTime = SessionClock::time_point;
/// Nanoseconds on this machine's CLOCK_MONOTONIC.
using LocalTime = LocalClock::time_point;

/// A duration in seconds, for arithmetic with velocities and rates.
constexpr double toSeconds(Duration d) { return std::chrono::duration<double>(d).count(); }

/// Converts seconds to a duration, rounded to a nanosecond.
/// @pre seconds is finite and its absolute value is below 292 years.
inline Duration fromSeconds(double seconds) { return Duration{std::llround(seconds * 1e9)}; }

} // namespace carina
