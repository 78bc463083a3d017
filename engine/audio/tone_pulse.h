#pragma once

#include "engine/core/units.h"

#include <span>

namespace carina
{

/// A tone with harmonics that rises, lasts and falls.
struct TonePulse {
    Frequency pitch;                   ///< of the fundamental
    std::span<const double> harmonics; ///< relative amplitudes: of the fundamental, twice it, ...
    double rise_s = 0.0;               ///< half a period of a cosine, and so is the fall
    double plateau_s = 0.0;
    double fall_s = 0.0;

    [[nodiscard]] double lasts_s() const { return rise_s + plateau_s + fall_s; }
};

/// The envelope of a pulse at a time since its begin: 0 to 1, and 0 outside of it.
[[nodiscard]] double envelopeOf(const TonePulse& pulse, double time_s);

/// The amplitude of a pulse at a time since its begin; at most 1, and continuous.
[[nodiscard]] double sampleOf(const TonePulse& pulse, double time_s);

} // namespace carina
