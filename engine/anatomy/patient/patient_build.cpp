#include "engine/anatomy/patient/patient_build.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Beyond this much of the usual weight, a body mass index of 26 in adults, there is fat.
constexpr double kLeanShare = 26.0 / (77.0 / (1.75 * 1.75));
/// How fast weight beyond the lean one takes the expiratory reserve: exponentially (Jones and
/// Nzekwu, Chest 2006;130:827), so that 127 kg at 175 cm are left with 11 ml/kg (Benumof).
constexpr double kReserveLostToFat = 3.7;

} // namespace

PatientBuild buildOf(const PatientDimensions& dimensions)
{
    return {dimensions.height, dimensions.weightInKilograms, dimensions.ageInYears, dimensions.sex};
}

double usualWeight(const PatientBuild& build)
{
    return usualBodyMassIndex(build.ageInYears) * build.height.si * build.height.si;
}

double lungWeight(const PatientBuild& build)
{
    const double usual = usualWeight(build);
    return std::clamp(build.weightInKilograms, usual, kLeanShare * usual);
}

LungVolumes lungVolumesOf(const PatientBuild& build)
{
    const Volume perKilogram = millilitres(lungWeight(build));
    const double fat = std::max(0.0, build.weightInKilograms / lungWeight(build) - 1.0);
    const double reserve = 14.0 * std::exp(-kReserveLostToFat * fat);
    return {16.0 * perKilogram, (16.0 + reserve) * perKilogram, 80.0 * perKilogram};
}

} // namespace carina
