#pragma once

#include "engine/audio/gain_ramp.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace carina
{

/// What can be made louder, softer or mute by itself.
enum class SoundKind : std::uint8_t {
    Oximeter, ///< a tone for each pulse
    Alarm,
    Breath, ///< what the stethoscope hears of lungs and stomach
    Heart,  ///< likewise of the heart
};
inline constexpr std::array kSoundKinds{SoundKind::Oximeter, SoundKind::Alarm, SoundKind::Breath,
                                        SoundKind::Heart};

/// One amplitude of each kind, in their order.
using SoundSamples = std::array<double, kSoundKinds.size()>;

/// Adds the kinds of sound, each by its volume, and limits what comes out.
///
/// Volumes go by ramps. The limiter divides by as much as keeps each sample within kCeiling, at
/// once, and lets go with the time constant kRelease_s.
class SoundMixer
{
public:
    static constexpr double kCeiling = 0.95;
    static constexpr double kRelease_s = 0.2; ///< of ours

    /// @param volume 0 to 1, as an amplitude
    void setVolume(SoundKind kind, double volume);
    void setMuted(SoundKind kind, bool muted);

    [[nodiscard]] double mix(const SoundSamples& samples);

private:
    struct Channel {
        double volume = 1.0;
        bool isMuted = false;
        GainRamp gain{1.0};
    };

    void aim(Channel& channel);

    std::array<Channel, kSoundKinds.size()> m_channels;
    double m_limit = 1.0; ///< what the sum is multiplied by
};

} // namespace carina
