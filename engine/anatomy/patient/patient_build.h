#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/core/units.h"

namespace carina
{

/// The figures of a patient from which the size of lungs and airways is computed.
struct PatientBuild {
    Length height = metres(1.75);
    double weightInKilograms = 77.0;
    double ageInYears = 30.0;
    Sex sex = Sex::Male;

    friend bool operator==(const PatientBuild&, const PatientBuild&) = default;
};

/// The build of a patient that is given by dimensions.
[[nodiscard]] PatientBuild buildOf(const PatientDimensions& dimensions);

/// Volumes of both lungs together.
struct LungVolumes {
    Volume residual;
    Volume functionalResidual;
    Volume totalCapacity;
};

/// Body weight of Habitus::Normal at this height and age, kg.
[[nodiscard]] double usualWeight(const PatientBuild& build);

/// The weight to which lungs and chest wall are proportional, kg: the patient's own between the
/// usual one and a body mass index of 26 in adults (26/25.1 times the usual one). Weight beyond it
/// is fat and adds no lung; a slim patient has the lungs of the usual weight, since volumes
/// depend on height and do not fall with a low weight (Jones and Nzekwu, Chest 2006;130:827).
[[nodiscard]] double lungWeight(const PatientBuild& build);

/// Residual volume, functional residual capacity and total capacity of 16, 30 and 80 ml per
/// kilogram of lungWeight (Pulse RespiratoryMethodology); infants 16, 21 and 63 ml/kg, and on
/// straight lines from there to six years. Fat reduces the expiratory reserve of 14 ml/kg by the
/// factor exp(-3.7 (weight / lungWeight - 1)) (docs/mechanics.md). The lungs that are drawn and the
/// mechanics take their volumes from here.
[[nodiscard]] LungVolumes lungVolumesOf(const PatientBuild& build);

} // namespace carina
