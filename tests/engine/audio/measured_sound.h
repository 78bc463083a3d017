#pragma once

#include "engine/audio/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace carina::test
{

/// So many seconds of what a sound gives.
template <class Sound> std::vector<double> heard(Sound& sound, double seconds)
{
    std::vector<double> samples(static_cast<std::size_t>(seconds * kSoundRate));
    for (double& sample : samples)
        sample = sound.next();
    return samples;
}

/// Amplitude of the sine of a frequency in samples, by Goertzel's recursion under a Hann window.
inline double amplitudeAt(std::span<const double> samples, double frequency_hz)
{
    const double turn = 2.0 * std::cos(2.0 * std::numbers::pi * frequency_hz / kSoundRate);
    const double count = static_cast<double>(samples.size());
    const double windowTurn = 2.0 * std::cos(2.0 * std::numbers::pi / count);
    double windowBefore = 0.5 * windowTurn; // cosines of the window, by the same recursion
    double window = 1.0;
    double before = 0.0;
    double last = 0.0;
    for (const double sample : samples) {
        const double next = (1.0 - window) * sample + turn * last - before;
        before = std::exchange(last, next);
        windowBefore = std::exchange(window, windowTurn * window - windowBefore);
    }
    const double power = last * last + before * before - turn * last * before;
    return 2.0 * std::sqrt(std::max(0.0, power)) / count;
}

/// The loudest frequency from `low` to `high`, in steps of `step`, hertz.
inline double loudest(std::span<const double> samples, double low, double high, double step)
{
    double best = low;
    double most = 0.0;
    for (double f = low; f <= high; f += step) {
        const double amplitude = amplitudeAt(samples, f);
        if (amplitude > most)
            best = f;
        most = std::max(most, amplitude);
    }
    return best;
}

/// Root of the mean square.
inline double effective(std::span<const double> samples)
{
    double sum = 0.0;
    for (const double sample : samples)
        sum += sample * sample;
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

/// Power from `low` to `high` hertz, in any unit, from lines `step` apart.
inline double powerBetween(std::span<const double> samples, double low, double high,
                           double step = 20.0)
{
    double sum = 0.0;
    for (double f = low; f < high; f += step)
        sum += std::pow(amplitudeAt(samples, f), 2.0);
    return sum;
}

/// The largest step from one sample to the next.
inline double largestStep(std::span<const double> samples)
{
    double largest = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        largest = std::max(largest, std::abs(samples[i] - samples[i - 1]));
    return largest;
}

/// The part of samples between two times, seconds.
inline std::span<const double> between(std::span<const double> samples, double from_s, double to_s)
{
    const auto begin = static_cast<std::size_t>(from_s * kSoundRate);
    return samples.subspan(begin, static_cast<std::size_t>(to_s * kSoundRate) - begin);
}

} // namespace carina::test
