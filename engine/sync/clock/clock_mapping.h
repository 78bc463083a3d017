#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// Converts local time to session time. A value: it is copied to the threads that need the time.
///
/// Session time is local time plus an offset that changes with the skew of the two clocks. A
/// correction of the offset is spread over time (slewed) at 1/kSlewDivisor, so that session time
/// never jumps and never runs backwards.
class ClockMapping
{
public:
    /// Largest slew rate, as a divisor: 500 ppm.
    static constexpr int kSlewDivisor = 2000;

    /// @param skew seconds of session time per second of local time, less 1
    ClockMapping(LocalTime start, Duration offset, double skew = 0.0)
        : m_start{start}, m_offset{offset}, m_skew{skew}
    {
    }

    [[nodiscard]] SessionTime at(LocalTime t) const;
    /// The local time at which it is session time t.
    [[nodiscard]] LocalTime localAt(SessionTime t) const;
    /// Slews from `start` on towards the mapping that has `offset` at `start`, and `skew` from then
    /// on.
    void slewTo(Duration offset, LocalTime start, double skew = 0.0);
    /// The part of the last correction that is still to be made at local time t.
    [[nodiscard]] Duration toGo(LocalTime t) const;

private:
    [[nodiscard]] Duration offsetAt(LocalTime t) const;

    LocalTime m_start;
    Duration m_offset; // session time less local time, at m_start
    double m_skew;
    Duration m_correction{}; // to be added to the offset from m_start on
};

} // namespace carina
