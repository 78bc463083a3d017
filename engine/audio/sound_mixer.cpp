#include "engine/audio/sound_mixer.h"

#include "engine/audio/sampling.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

void SoundMixer::aim(Channel& channel) { channel.gain.aim(channel.isMuted ? 0.0 : channel.volume); }

void SoundMixer::setVolume(SoundKind kind, double volume)
{
    CARINA_EXPECTS(volume >= 0.0 && volume <= 1.0);
    Channel& channel = m_channels[static_cast<std::size_t>(kind)];
    channel.volume = volume;
    aim(channel);
}

void SoundMixer::setMuted(SoundKind kind, bool muted)
{
    Channel& channel = m_channels[static_cast<std::size_t>(kind)];
    channel.isMuted = muted;
    aim(channel);
}

double SoundMixer::mix(const SoundSamples& samples)
{
    static const double kRelease = 1.0 - std::exp(-1.0 / (kRelease_s * kSoundRate));
    double sum = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        sum += m_channels[i].gain.next() * samples[i];
    m_limit += kRelease * (1.0 - m_limit);
    if (std::abs(sum) * m_limit > kCeiling)
        m_limit = kCeiling / std::abs(sum);
    return m_limit * sum;
}

} // namespace carina
