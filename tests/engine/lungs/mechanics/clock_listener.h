#pragma once

#include "engine/lungs/mechanics/breath_clock.h"

#include <cmath>

namespace carina::test
{

inline constexpr double kClockStep = 2e-3; // s
inline constexpr Frequency kSet = perMinute(16.0);

/// A clock that hears a manikin.
struct Listener {
    BreathClock clock{kSet};
    double now = 0.0;

    void until(double t)
    {
        while (now < t) {
            clock.advance(kSet, kClockStep);
            now += kClockStep;
        }
    }
    void hearAt(double t)
    {
        until(t);
        clock.trigger(now - t);
    }
    void hear(double from, double period, int breaths)
    {
        for (int i = 0; i < breaths; ++i)
            hearAt(from + i * period);
    }
    /// Breaths from the nearest beginning of the clock's own; the manikin's at `t` was the last.
    [[nodiscard]] double phaseErrorAt(double t) const
    {
        const double then = clock.state().breaths - clock.state().rate.si * (now - t);
        return std::abs(then - std::round(then));
    }
    [[nodiscard]] double rate_perMin() const { return inPerMinute(clock.state().rate); }
};

} // namespace carina::test
