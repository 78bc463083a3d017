#pragma once

namespace carina
{

/// A digital filter of second order. The coefficients are those of the "Cookbook formulae for audio
/// EQ biquad filter coefficients" (Bristow-Johnson), by the bilinear transform at kSoundRate.
class SoundFilter
{
public:
    /// -3 dB at the corner and -12 dB per octave above it (Butterworth).
    [[nodiscard]] static SoundFilter lowPass(double corner_hz);
    /// Likewise, below it.
    [[nodiscard]] static SoundFilter highPass(double corner_hz);

    [[nodiscard]] double next(double sample);

private:
    struct Coefficients {
        double b0, b1, b2;
        double a0, a1, a2;
    };

    explicit SoundFilter(const Coefficients& c);

    double m_b0, m_b1, m_b2, m_a1, m_a2; ///< divided by a0
    double m_first = 0.0;                ///< state of the transposed direct form II
    double m_second = 0.0;
};

} // namespace carina
