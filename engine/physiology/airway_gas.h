#pragma once

#include "engine/physiology/body_state.h"

namespace carina
{

/// How gas moves in one step.
struct GasMove {
    std::array<double, 2> volume_ml{};   ///< of each lung's gas at the end of the step
    std::array<double, 2> passable_ml{}; ///< at most through each lung's bronchi, either way
    double deadSpace_ml = 0.0;           ///< from the opening to the carina
    GasShares supplied;                  ///< at the opening
    /// How much less carbon dioxide the first gas of an exhalation has than the last, as a share:
    /// lungs that empty unevenly empty first the parts that are well ventilated, where it is lower.
    std::array<double, 2> slant{};
};

/// Moves gas between opening, airway and lungs, so that each lung holds the given volume. What the
/// blood takes up is replaced from the airway (apnoeic oxygenation), as far as the bronchi let it.
/// The airway is a row of well mixed cells through which the gas goes upwind, so that a front is
/// about a fifth of the dead space wide.
/// @returns the volume that passed the opening, positive inwards
double move(AirwayGas& gas, const GasMove& how);

/// Fills lungs and airway with alveolar gas.
void fill(AirwayGas& gas, const std::array<double, 2>& volume_ml, const GasShares& alveolar);

[[nodiscard]] double totalOf(const LungGas& gas);
[[nodiscard]] GasShares sharesOf(const LungGas& gas);
/// How far the present breath has been exhaled, 0 to 1.
[[nodiscard]] double exhaledShare(const AirwayGas& gas);

} // namespace carina
