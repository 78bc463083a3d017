#pragma once

#include "engine/audio/sampling.h"
#include "engine/audio/sound_mixer.h"

namespace carina::test
{

/// By what a mixer multiplies a soft sound of a kind once its ramps are over; 0 where it is mute.
inline double gainOf(SoundMixer mixer, SoundKind kind)
{
    constexpr double kSoft = 0.1; // no limiter acts on it
    SoundSamples samples{};
    samples[static_cast<std::size_t>(kind)] = kSoft;
    double heard = 0.0;
    for (double left_s = 2.0 * GainRamp::kUsual_s; left_s > 0.0; left_s -= 1.0 / kSoundRate)
        heard = mixer.mix(samples);
    return heard / kSoft;
}

} // namespace carina::test
