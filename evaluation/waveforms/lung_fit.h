#pragma once

#include "engine/core/units.h"

#include <optional>
#include <vector>

namespace carina
{

/// Measurements at the airway opening: pressure, flow into the lung, and volume inspired since the
/// start of the breath.
struct LungSamples {
    std::vector<double> pressure_cmH2O;
    std::vector<double> flow_lPerS;
    std::vector<double> volume_l;
};

/// The linear single-compartment model of a lung: P = P0 + R Q + V / C.
struct LinearLung {
    Pressure baseline;     ///< P0
    Resistance resistance; ///< R
    Compliance compliance; ///< C
};

/// Fits the model by linear least squares.
/// @returns std::nullopt if the samples do not determine R and C, or give one that is not above 0.
[[nodiscard]] std::optional<LinearLung> fitLinear(const LungSamples& samples);

} // namespace carina
