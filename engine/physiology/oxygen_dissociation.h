#pragma once

namespace carina
{

/// Saturation of haemoglobin at a partial pressure of oxygen: S = 1 / (1 + 23400 / (P^3 + 150 P)),
/// within 0.0055 of measured values (Severinghaus, J Appl Physiol 1979;46:599). At a temperature of
/// 37 degrees and a pH of 7.4; the shift by acid and carbon dioxide is not in the model.
[[nodiscard]] double oxygenSaturation(double pressure_mmHg);

/// Oxygen in blood, in millilitres at 0 degrees and 760 mmHg dry, per litre: 1.36 ml per gram of
/// saturated haemoglobin and 0.031 ml/mmHg dissolved.
[[nodiscard]] double oxygenContent_mlPerL(double pressure_mmHg, double haemoglobin_gPerL);

/// The inverse of oxygenContent_mlPerL, to 1e-6 mmHg, up to 800 mmHg.
[[nodiscard]] double oxygenPressureOf(double content_mlPerL, double haemoglobin_gPerL);

} // namespace carina
