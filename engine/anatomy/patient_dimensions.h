#pragma once

#include "engine/core/units.h"

#include <cstdint>

namespace carina
{

/// The patients that Carina makes itself.
enum class BuiltinPatient : std::uint8_t { Adult, TwelveYears };

/// One main bronchus: from the carina to its first lobar branch.
struct MainBronchusDimensions {
    Length length;     ///< along its axis, from the level of the carina
    Angle fromTrachea; ///< between its axis and the trachea's axis produced
    Length diameter;
};

/// The figures a built-in patient is made from.
struct PatientDimensions {
    Length height;
    double weightInKilograms = 0.0;
    double ageInYears = 0.0;
    Length cordsToCarina;
    Length tracheaLength;   ///< lower border of the cricoid to the carina
    Length tracheaSagittal; ///< front to back, mean of rings and gaps
    Length tracheaCoronal;  ///< side to side
    int tracheaRings = 0;
    MainBronchusDimensions rightBronchus;
    MainBronchusDimensions leftBronchus;
    Length teethToCarina; ///< along the path of a tube
    Volume functionalResidualCapacity;
    double rightLungShare = 0.0; ///< of the functional residual capacity
    Volume tidalVolume;
    Frequency breathingRate;
    double inspiratoryFraction = 0.0; ///< inspiration's share of a breath
    Length tubeInnerDiameter;         ///< of the tracheal tube that fits
};

/// The figures of a built-in patient; patient_dimensions.cpp gives the source of each.
[[nodiscard]] PatientDimensions dimensionsOf(BuiltinPatient patient);

} // namespace carina
