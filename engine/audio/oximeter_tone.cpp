#include "engine/audio/oximeter_tone.h"

#include "engine/audio/sampling.h"
#include "engine/audio/tone_pulse.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kFullPitch_hz = 880.0;
constexpr double kOctave = 0.2; ///< of saturation
constexpr double kLeastSaturation = 0.5;
constexpr std::array kOximeterHarmonics{1.0, 0.25, 0.1}; ///< of ours: softer than an alarm

} // namespace

Frequency oximeterPitch(double saturation)
{
    const double heard = std::clamp(saturation, kLeastSaturation, 1.0);
    return hertz(kFullPitch_hz * std::exp2((heard - 1.0) / kOctave));
}

void OximeterTone::pulse(double saturation)
{
    if (m_pitch)
        return;
    m_pitch = oximeterPitch(saturation);
    m_sample = 0;
}

double OximeterTone::next()
{
    if (!m_pitch)
        return 0.0;
    const TonePulse tone{*m_pitch, kOximeterHarmonics, kRise_s, kPlateau_s, kFall_s};
    const double time_s = static_cast<double>(m_sample++) / kSoundRate;
    if (time_s >= tone.lasts_s())
        m_pitch.reset();
    return sampleOf(tone, time_s);
}

} // namespace carina
