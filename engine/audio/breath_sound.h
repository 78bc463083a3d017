#pragma once

#include "engine/audio/gain_ramp.h"
#include "engine/audio/noise.h"
#include "engine/audio/sound_filter.h"
#include "engine/core/units.h"

#include <cstddef>
#include <cstdint>

namespace carina
{

/// Where a breath is listened to.
enum class BreathPlace : std::uint8_t {
    Lung,    ///< through lung and chest wall: vesicular, to some 400 Hz
    Trachea, ///< at the neck: to some 850 Hz
};

/// The sound of gas that moves in the airways of one lung, or in the trachea.
///
/// It is noise whose amplitude grows with the flow to the power 1.66 (Gavriely and Cugell, J Appl
/// Physiol 1996;80:5). In the trachea its spectrum is flat to a sharp fall at some 850 Hz; through
/// the lung it has lost its high frequencies (Pasterkamp, Kraman and Wodicka, AJRCCM 1997;156:974),
/// more in expiration. Narrowed airways wheeze: a tone near 400 Hz, mostly in expiration. Corners
/// as numbers and the wheeze's shares are of ours.
class BreathSound
{
public:
    /// The flow that is heard with an amplitude of about kLoudness.
    static constexpr VolumeFlow kFullFlow = litresPerSecond(0.5);
    static constexpr double kLoudness = 0.5;
    static constexpr double kFlowExponent = 1.66;
    /// Of a lung's amplitude in inspiration: 1 / 2.43 to 1 / 1.99 (Gavriely and Cugell, likewise).
    static constexpr double kExpiration = 0.45;
    static constexpr double kWheeze_hz = 400.0;

    /// @pre seed is not 0
    BreathSound(BreathPlace place, std::uint64_t seed);

    /// From the next sample on, by a ramp.
    /// @param flow into the lung; negative: out of it
    /// @param obstruction 0: free, 1: hardly open
    void set(VolumeFlow flow, double obstruction);

    [[nodiscard]] double next();

private:
    [[nodiscard]] double wheeze();

    BreathPlace m_place;
    Noise m_noise;
    SoundFilter m_low;
    SoundFilter m_steeper;
    SoundFilter m_high;
    GainRamp m_hiss{0.0};
    GainRamp m_whistle{0.0};
    std::size_t m_sample = 0;
};

/// What is heard over the stomach while gas goes into it: bubbles, which ring at 150 to 400 Hz and
/// die away, one after the other, the sooner the more gas flows (of ours; that a bubble rings as a
/// damped sine is of Minnaert, Phil Mag 1933;16:235).
class StomachSound
{
public:
    /// The flow from which on bubbles follow each other as fast as they do at most.
    static constexpr VolumeFlow kFullFlow = litresPerSecond(0.5);
    /// How soon the next one begins after the last died away, at kFullFlow.
    static constexpr double kMostBubbles_perSecond = 25.0;

    /// @pre seed is not 0
    explicit StomachSound(std::uint64_t seed) : m_noise{seed} {}

    /// @param flow into the stomach; gas that comes back gurgles alike
    void set(VolumeFlow flow);

    [[nodiscard]] double next();

private:
    void bubble();

    Noise m_noise;
    double m_chance = 0.0; ///< of a bubble to begin at a sample
    double m_amplitude = 0.0;
    double m_turn = 0.0; ///< radians since the bubble began
    double m_step = 0.0; ///< radians of a sample
};

} // namespace carina
