#include "engine/audio/heart_tones.h"

#include "engine/audio/sampling.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// A beat of a low sound: it swells and fades as a squared sine.
double thud(double time_s, double lasts_s, double pitch_hz)
{
    if (time_s <= 0.0 || time_s >= lasts_s)
        return 0.0;
    const double swell = std::sin(std::numbers::pi * time_s / lasts_s);
    return swell * swell * std::sin(2.0 * std::numbers::pi * pitch_hz * time_s);
}

} // namespace

double HeartTones::ejection_s(Frequency heartRate)
{
    return std::max(kLeastEjection_s, 0.413 - 0.0017 * inPerMinute(heartRate));
}

void HeartTones::beat(Frequency heartRate)
{
    CARINA_EXPECTS(heartRate.si > 0.0);
    if (m_ejection_s)
        return;
    m_ejection_s = ejection_s(heartRate);
    m_sample = 0;
}

double HeartTones::next()
{
    if (!m_ejection_s)
        return 0.0;
    const double time_s = static_cast<double>(m_sample++) / kSoundRate;
    const double second_s = time_s - *m_ejection_s;
    if (second_s >= kSecond_s)
        m_ejection_s.reset();
    return thud(time_s, kFirst_s, kFirst_hz) + 0.8 * thud(second_s, kSecond_s, kSecond_hz);
}

} // namespace carina
