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

/// Per kilogram. Infants rest at 21 ml/kg up to one year: 72, 114, 168, 236 ml at 50, 60, 70, 80 cm
/// (helium, collated by Stocks and Quanjer, Eur Respir J 1995;8:492). Their capacity is 63 ml/kg
/// (textbooks). Both go on straight lines to those of older people.
double restingPerKilogram_ml(double years)
{
    return 30.0 - 9.0 * std::clamp((kSchoolAge_years - years) / (kSchoolAge_years - 1.0), 0.0, 1.0);
}
double capacityPerKilogram_ml(double years)
{
    return 80.0 - 17.0 * std::max(0.0, 1.0 - years / kSchoolAge_years);
}

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
    const double usual = restingPerKilogram_ml(build.ageInYears) - 16.0;
    const double reserve = usual * std::exp(-kReserveLostToFat * fat);
    return {16.0 * perKilogram, (16.0 + reserve) * perKilogram,
            capacityPerKilogram_ml(build.ageInYears) * perKilogram};
}

} // namespace carina
