#pragma once

#include "engine/core/units.h"

#include <optional>
#include <vector>

namespace carina
{

/// What was measured at the opening of a lung: pressure, flow into it, and gas that the breath has
/// brought.
struct LungSamples {
    std::vector<double> pressure_cmH2O;
    std::vector<double> flow_lPerS;
    std::vector<double> volume_l;
};

/// What a ventilator tells of a lung: P = P0 + R Q + V / C.
struct LinearLung {
    Pressure baseline;     ///< P0
    Resistance resistance; ///< R
    Compliance compliance; ///< C
};

/// By least squares.
/// @returns nothing where the samples do not tell R from C, or tell that one is not above 0.
[[nodiscard]] std::optional<LinearLung> fitLinear(const LungSamples& samples);

} // namespace carina
