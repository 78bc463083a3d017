#include "engine/audio/sound_filter.h"

#include "engine/audio/sampling.h"
#include "engine/core/expects.h"

#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr double kButterworth = 0.5 * std::numbers::sqrt2; ///< quality without overshoot

/// Cosine of the angle that a frequency turns in a sample, and the cookbook's alpha.
struct Turn {
    double cosine;
    double alpha;
};

Turn turnOf(double frequency_hz)
{
    CARINA_EXPECTS(frequency_hz > 0.0 && frequency_hz < 0.5 * kSoundRate);
    const double angle = 2.0 * std::numbers::pi * frequency_hz / kSoundRate;
    return {std::cos(angle), std::sin(angle) / (2.0 * kButterworth)};
}

} // namespace

SoundFilter::SoundFilter(const Coefficients& c)
    : m_b0{c.b0 / c.a0}, m_b1{c.b1 / c.a0}, m_b2{c.b2 / c.a0}, m_a1{c.a1 / c.a0}, m_a2{c.a2 / c.a0}
{
}

SoundFilter SoundFilter::lowPass(double corner_hz)
{
    const auto [cosine, alpha] = turnOf(corner_hz);
    const double b = 1.0 - cosine;
    return SoundFilter{{0.5 * b, b, 0.5 * b, 1.0 + alpha, -2.0 * cosine, 1.0 - alpha}};
}

SoundFilter SoundFilter::highPass(double corner_hz)
{
    const auto [cosine, alpha] = turnOf(corner_hz);
    const double b = 1.0 + cosine;
    return SoundFilter{{0.5 * b, -b, 0.5 * b, 1.0 + alpha, -2.0 * cosine, 1.0 - alpha}};
}

double SoundFilter::next(double sample)
{
    const double out = m_b0 * sample + m_first;
    m_first = m_b1 * sample - m_a1 * out + m_second;
    m_second = m_b2 * sample - m_a2 * out;
    return out;
}

} // namespace carina
