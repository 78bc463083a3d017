#pragma once

#include "engine/core/units.h"

namespace carina
{

/// How a patient breathes: one breath after another of the same shape.
struct BreathingPattern {
    Frequency rate = perMinute(19.0);
    Volume tidalVolume = millilitres(280.0);
    double inspiratoryFraction = 0.41; ///< inspiration's share of the breath, 0.1 to 0.9

    friend bool operator==(const BreathingPattern&, const BreathingPattern&) = default;
};

/// Gas above functional residual capacity at a phase of the breath (0 at the start of inspiration,
/// 1 at the end of expiration), both lungs together.
///
/// Inspiratory flow is a half sine, so V = VT (1 - cos(pi f)) / 2 over the inspired share f.
/// Expiration is passive: V = VT (exp(-k e) - exp(-k)) / (1 - exp(-k)) over the expired share e,
/// with k = kExpiratoryDecay time constants in an expiration, brought to exactly 0 at its end so
/// that breath joins breath. The shape depends on the phase alone: a change of rate never makes the
/// volume jump.
///
/// @pre 0 <= phase <= 1 and the inspiratory fraction lies in 0.1..0.9.
[[nodiscard]] Volume inspiredVolume(const BreathingPattern& pattern, double phase);

/// Time constants of the respiratory system in one expiration.
inline constexpr double kExpiratoryDecay = 4.0;

} // namespace carina
