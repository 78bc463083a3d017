#pragma once

#include "engine/core/units.h"

#include <cstdint>

namespace carina
{

/// When the breaths of a patient begin: at a rate that was set, or locked to the breaths of a
/// manikin, whose beginnings are told as they are seen.
///
/// Two beginnings give a rate. The clock then runs at it, faster or slower by at most kMostPull
/// until its own beginnings fall on the manikin's; its rate changes by at most kSlew of the faster
/// of old and new per second, so the phase neither jumps nor runs back. One beginning or two that
/// were missed do not matter, where an interval is within kNearWhole of a whole number of breaths
/// and the one before it was not bridged as well; after kPatience breaths without one the clock
/// goes back to the rate set. Beginnings that follow each other faster than anybody breathes are
/// not believed.
class BreathClock
{
public:
    /// Everything that decides what follows.
    struct State {
        double breaths = 0.0;      ///< since the start, whole and part
        Frequency rate;            ///< at present
        Frequency measured;        ///< of the manikin; 0: not known
        double pull = 0.0;         ///< to be caught up with, half a breath either way at the most
        double sinceTrigger = 0.0; ///< seconds since the last beginning that was believed
        bool triggered = false;    ///< there was one
        bool bridged = false;      ///< it came after some that were missed

        friend bool operator==(const State&, const State&) = default;
    };

    explicit BreathClock(Frequency rate) { m_state.rate = rate; }
    explicit BreathClock(const State& state) : m_state{state} {}

    /// A breath of the manikin began so many seconds ago.
    void trigger(double secondsAgo);
    /// Time goes on by a step.
    void advance(Frequency set, double seconds);

    [[nodiscard]] const State& state() const { return m_state; }
    /// 0 at the beginning of a breath, to below 1.
    [[nodiscard]] double phase() const;
    [[nodiscard]] bool isLocked() const;

private:
    [[nodiscard]] double breathsIn(double interval) const;

    State m_state;
};

inline constexpr double kMostPull = 0.25; ///< of the rate, faster or slower
inline constexpr double kSlew = 0.5;      ///< of the rate, per second
inline constexpr double kPatience = 3.5;  ///< breaths
inline constexpr double kNearWhole = 0.2; ///< breaths
/// Slowest and fastest breathing that is believed of a manikin.
inline constexpr Frequency kSlowestManikin = perMinute(4.0);
inline constexpr Frequency kFastestManikin = perMinute(60.0);

} // namespace carina
