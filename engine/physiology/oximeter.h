#pragma once

#include "engine/physiology/body_state.h"

namespace carina
{

/// A finger probe: arterial blood arrives there after kWayToFinger samples of kFingerSampleEvery,
/// and the oximeter averages with a time constant of kAveraging. A steady fall is shown 12 s late
/// (10 to 15 are usual [textbook]); the parts are ours.
void watch(OximeterState& state, double saturation, double seconds);

/// As if the saturation had been this for long.
[[nodiscard]] OximeterState settledAt(double saturation);

inline constexpr double kFingerSampleEvery = 0.5; ///< s
inline constexpr double kAveraging = 4.0;         ///< s

} // namespace carina
