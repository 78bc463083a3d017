#pragma once

#include "engine/core/units.h"

namespace carina
{

/// Breathing as it is set: breaths of equal length and shape. Unless set, it is the quiet breath
/// (restingPattern) of the built-in patient of twelve years.
struct BreathingPattern {
    Frequency rate = perMinute(19.0);
    Volume tidalVolume = millilitres(280.0);
    double inspiratoryFraction = 0.4125; ///< inspiration's share of the breath, 0.1 to 0.9

    friend bool operator==(const BreathingPattern&, const BreathingPattern&) = default;
};

} // namespace carina
