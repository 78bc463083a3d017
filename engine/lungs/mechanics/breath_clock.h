#pragma once

#include "engine/core/units.h"

#include <cstdint>

namespace carina
{

/// When the breaths of a patient begin: at a set rate, or locked to the breaths of a manikin, each
/// reported by trigger().
///
/// Two triggers give a rate. The clock then runs at this rate, faster or slower by at most
/// kMostPull until its breaths begin at the triggers. Its rate changes by at most kSlew of the
/// larger of old and new rate per second, so that the phase neither jumps nor decreases. Missed
/// triggers are bridged where an interval is within kNearWhole of a whole number of breaths and the
/// previous interval was not bridged. After kPatience breaths without a trigger the clock returns
/// to the set rate. Triggers that follow each other faster than kFastestManikin are ignored.
class BreathClock
{
public:
    /// The complete state of the clock.
    struct State {
        double breaths = 0.0;      ///< since the start, with fraction
        Frequency rate;            ///< now
        Frequency measured;        ///< of the manikin; 0: not known
        double pull = 0.0;         ///< phase error still to be corrected, in breaths, -0.5 to 0.5
        double sinceTrigger = 0.0; ///< seconds since the last accepted trigger
        bool triggered = false;    ///< there was an accepted trigger
        bool bridged = false;      ///< the last interval contained missed triggers

        friend bool operator==(const State&, const State&) = default;
    };

    explicit BreathClock(Frequency rate) { m_state.rate = rate; }
    explicit BreathClock(const State& state) : m_state{state} {}

    /// A breath of the manikin began `secondsAgo` before now.
    void trigger(double secondsAgo);
    /// Advances by `seconds`. @param set rate used while the clock is not locked
    void advance(Frequency set, double seconds);

    [[nodiscard]] const State& state() const { return m_state; }
    /// Phase within the present breath, 0 <= phase < 1.
    [[nodiscard]] double phase() const;
    /// Whether the clock follows the manikin.
    [[nodiscard]] bool isLocked() const;

private:
    /// Number of breaths in an interval between triggers: more than 1 where triggers were missed.
    [[nodiscard]] double breathsIn(double interval) const;

    State m_state;
};

inline constexpr double kMostPull = 0.25; ///< of the rate, faster or slower
inline constexpr double kSlew = 0.5;      ///< of the rate, per second
inline constexpr double kPatience = 3.5;  ///< breaths
inline constexpr double kNearWhole = 0.2; ///< breaths
/// Slowest and fastest breathing rate that is accepted from a manikin.
inline constexpr Frequency kSlowestManikin = perMinute(4.0);
inline constexpr Frequency kFastestManikin = perMinute(60.0);

} // namespace carina
