#pragma once

namespace carina
{

/// Lead II of the electrocardiogram at a phase of the beat, millivolts. P, Q, R, S and T are five
/// bell curves (form as McSharry et al., IEEE Trans Biomed Eng 2003;50:289; heights and widths
/// ours). The beat begins with the P wave; the QRS lasts equally long at every rate, and the
/// intervals around it go with the root of the duration of the beat.
/// @pre 0 <= phase < 1; the rate is above 0.
[[nodiscard]] double electrocardiogram_mV(double phase, double rate_perS);

/// What is farthest from zero of this in a step of so many seconds that ends at the phase, every 4
/// ms: as a monitor keeps the peaks that fall between two points of its screen, so that the R waves
/// of even beats are drawn equally high.
[[nodiscard]] double electrocardiogramPeak_mV(double phase, double rate_perS, double seconds);

/// The pulse wave at the finger at a phase of the beat, 0 to 1: upstroke, fall and a dicrotic
/// wave, a quarter of a second behind the R wave. The shape is ours.
/// @pre 0 <= phase < 1; the rate is above 0.
[[nodiscard]] double pulseWave(double phase, double rate_perS);

} // namespace carina
