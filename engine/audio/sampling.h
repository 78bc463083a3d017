#pragma once

namespace carina
{

/// All sounds are computed at this rate, samples per second, as amplitudes from -1 to 1.
inline constexpr double kSoundRate = 48000.0;

} // namespace carina
