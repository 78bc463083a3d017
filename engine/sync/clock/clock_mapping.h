#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// Local time to session time. A value: copied to whoever needs the time.
///
/// Session time is local time and an offset that grows with the skew of the two clocks. A
/// correction is spread: it is worked off at 1/kSlewDivisor, so that session time never jumps and
/// never runs backwards.
class ClockMapping
{
public:
    /// 500 ppm.
    static constexpr int kSlewDivisor = 2000;

    /// @param skew seconds of session time per second of local time, less 1
    ClockMapping(LocalTime start, Duration offset, double skew = 0.0)
        : m_start{start}, m_offset{offset}, m_skew{skew}
    {
    }

    [[nodiscard]] SessionTime at(LocalTime t) const;
    /// Works from `start` on towards what would be `offset` at `start`, and from there on has
    /// `skew`.
    void slewTo(Duration offset, LocalTime start, double skew = 0.0);
    /// Of the correction, at local time t.
    [[nodiscard]] Duration toGo(LocalTime t) const;

private:
    [[nodiscard]] Duration offsetAt(LocalTime t) const;

    LocalTime m_start;
    Duration m_offset; // session time less local time, at m_start
    double m_skew;
    Duration m_correction{}; // to be added to it from there on
};

} // namespace carina
