#include "engine/audio/breath_sound.h"

#include "engine/audio/sampling.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr double kLungCorner_hz = 200.0;
constexpr double kTracheaCorner_hz = 850.0;
constexpr double kLeastHeard_hz = 100.0; ///< below it muscles and heart are louder
/// Brings filtered noise to the amplitude of the tones: the band is a small share of all noise.
constexpr double kLungLevel = 6.0;
constexpr double kTracheaLevel = 3.0;
constexpr double kGlide_hz = 6.0; ///< the wheeze's pitch sways by this
constexpr double kGlidesPerSecond = 1.3;
constexpr double kInspiredWheeze = 0.3; ///< of that in expiration

constexpr double kDampedIn_s = 0.02; ///< a bubble's amplitude falls to 1/e
constexpr double kBubbleOver = 1e-3; ///< amplitude below which it has died away
constexpr double kBubbleLowest_hz = 150.0;
constexpr double kBubbleHighest_hz = 400.0;

double cornerOf(BreathPlace place)
{
    return place == BreathPlace::Lung ? kLungCorner_hz : kTracheaCorner_hz;
}

} // namespace

BreathSound::BreathSound(BreathPlace place, std::uint64_t seed)
    : m_place{place},
      m_noise{seed},
      m_low{SoundFilter::lowPass(cornerOf(place))},
      m_steeper{SoundFilter::lowPass(2.0 * cornerOf(place))},
      m_high{SoundFilter::highPass(kLeastHeard_hz)}
{
}

void BreathSound::set(VolumeFlow flow, double obstruction)
{
    CARINA_EXPECTS(std::isfinite(flow.si) && obstruction >= 0.0 && obstruction <= 1.0);
    const bool isExpired = flow.si < 0.0;
    const double share = std::min(std::abs(flow / kFullFlow), 1.5);
    double loud = kLoudness * std::pow(share, kFlowExponent);
    if (isExpired && m_place == BreathPlace::Lung)
        loud *= kExpiration;
    m_hiss.aim(loud);
    m_whistle.aim(kLoudness * obstruction * std::min(share, 1.0)
                  * (isExpired ? 1.0 : kInspiredWheeze));
}

double BreathSound::next()
{
    const double level = m_place == BreathPlace::Lung ? kLungLevel : kTracheaLevel;
    const double hiss = m_high.next(m_steeper.next(m_low.next(m_noise.next())));
    return level * m_hiss.next() * hiss + wheeze();
}

/// A tone and its first two harmonics, whose pitch sways a little.
double BreathSound::wheeze()
{
    const double loud = m_whistle.next();
    const double time_s = static_cast<double>(m_sample++) / kSoundRate;
    if (loud == 0.0)
        return 0.0;
    const double sway =
        kGlide_hz / kGlidesPerSecond * std::sin(2.0 * std::numbers::pi * kGlidesPerSecond * time_s);
    const double turn = 2.0 * std::numbers::pi * kWheeze_hz * time_s + sway;
    return loud * (0.7 * std::sin(turn) + 0.2 * std::sin(2.0 * turn) + 0.1 * std::sin(3.0 * turn));
}

void StomachSound::set(VolumeFlow flow)
{
    CARINA_EXPECTS(std::isfinite(flow.si));
    const double share = std::min(std::abs(flow / kFullFlow), 1.0);
    m_chance = share * kMostBubbles_perSecond / kSoundRate;
}

/// Begins one, of a random pitch and loudness.
void StomachSound::bubble()
{
    const auto between = [this](double low, double high) {
        return low + 0.5 * (m_noise.next() + 1.0) * (high - low);
    };
    m_turn = 0.0;
    m_step = 2.0 * std::numbers::pi * between(kBubbleLowest_hz, kBubbleHighest_hz) / kSoundRate;
    m_amplitude = between(0.3, 0.8);
}

double StomachSound::next()
{
    static const double kDamping = std::exp(-1.0 / (kDampedIn_s * kSoundRate));
    const bool begins = 0.5 * (m_noise.next() + 1.0) < m_chance;
    if (m_amplitude < kBubbleOver) {
        if (!begins)
            return 0.0;
        bubble();
    }
    m_turn += m_step;
    m_amplitude *= kDamping;
    return m_amplitude * std::sin(m_turn);
}

} // namespace carina
