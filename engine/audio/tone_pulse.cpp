#include "engine/audio/tone_pulse.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace carina
{
namespace
{

/// From 0 to 1 while x goes from 0 to 1, without a corner at either end.
double easedRise(double x) { return 0.5 - 0.5 * std::cos(std::numbers::pi * x); }

} // namespace

double envelopeOf(const TonePulse& pulse, double time_s)
{
    const double left_s = pulse.lasts_s() - time_s;
    if (time_s <= 0.0 || left_s <= 0.0)
        return 0.0;
    if (time_s < pulse.rise_s)
        return easedRise(time_s / pulse.rise_s);
    return left_s < pulse.fall_s ? easedRise(left_s / pulse.fall_s) : 1.0;
}

double sampleOf(const TonePulse& pulse, double time_s)
{
    const double envelope = envelopeOf(pulse, time_s);
    if (envelope == 0.0)
        return 0.0;
    const double turn = 2.0 * std::numbers::pi * pulse.pitch.si * time_s;
    double sum = 0.0;
    double order = 0.0;
    for (const double amplitude : pulse.harmonics) {
        order += 1.0;
        sum += amplitude * std::sin(order * turn);
    }
    return envelope * sum / std::accumulate(pulse.harmonics.begin(), pulse.harmonics.end(), 0.0);
}

} // namespace carina
