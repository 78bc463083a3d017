#include "engine/physiology/heart_curves.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kRWave_s = 0.2; // after the beginning of a beat of one second

double bell(double distance, double width)
{
    const double ratio = distance / width;
    return std::exp(-0.5 * ratio * ratio);
}

/// How much shorter the intervals of a fast beat are.
double shortened(double rate_perS) { return std::sqrt(std::min(1.0, 1.0 / rate_perS)); }

} // namespace

double electrocardiogram_mV(double phase, double rate_perS)
{
    CARINA_EXPECTS(phase >= 0.0 && phase < 1.0 && rate_perS > 0.0);
    const double scale = shortened(rate_perS);
    const double fromR = phase / rate_perS - kRWave_s * scale;
    return 0.12 * bell(fromR + 0.14 * scale, 0.022 * scale) - 0.10 * bell(fromR + 0.025, 0.008)
           + 1.10 * bell(fromR, 0.011) - 0.22 * bell(fromR - 0.028, 0.009)
           + 0.28 * bell(fromR - 0.26 * scale, 0.045 * scale);
}

double electrocardiogramPeak_mV(double phase, double rate_perS, double seconds)
{
    constexpr double kSampleEvery_s = 0.004;
    double peak = electrocardiogram_mV(phase, rate_perS);
    for (double before = kSampleEvery_s; before < seconds; before += kSampleEvery_s) {
        const double earlier = phase - before * rate_perS;
        const double sample = electrocardiogram_mV(
            std::clamp(earlier - std::floor(earlier), 0.0, std::nextafter(1.0, 0.0)), rate_perS);
        if (std::abs(sample) > std::abs(peak))
            peak = sample;
    }
    return peak;
}

double pulseWave(double phase, double rate_perS)
{
    CARINA_EXPECTS(phase >= 0.0 && phase < 1.0 && rate_perS > 0.0);
    constexpr double kToFinger_s = 0.25;
    const double beats = phase - (kRWave_s * shortened(rate_perS) + kToFinger_s) * rate_perS;
    const double since = (beats - std::floor(beats)) / (rate_perS * shortened(rate_perS));
    // The wave before this one still falls.
    const double before = since + 1.0 / (rate_perS * shortened(rate_perS));
    const auto wave = [](double seconds) {
        const double rise = seconds / 0.14;
        return rise * std::exp(1.0 - rise) + 0.25 * bell(seconds - 0.45, 0.09);
    };
    return std::clamp(wave(since) + wave(before), 0.0, 1.0);
}

} // namespace carina
