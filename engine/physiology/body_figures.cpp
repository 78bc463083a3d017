#include "engine/physiology/body_figures.h"

#include "engine/lungs/mechanics/respiratory_system.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

struct AtAge {
    double years;
    double value;
};

/// On straight lines between the points, constant beyond them.
template <std::size_t Count> double atAge(const std::array<AtAge, Count>& points, double years)
{
    if (years <= points.front().years)
        return points.front().value;
    for (std::size_t i = 1; i < Count; ++i) {
        const AtAge& before = points[i - 1];
        const AtAge& after = points[i];
        if (years < after.years)
            return std::lerp(before.value, after.value,
                             (years - before.years) / (after.years - before.years));
    }
    return points.back().value;
}

constexpr std::array<AtAge, 7> kHeartRate{{{0.0, 127.0},
                                           {1.0 / 12.0, 145.0},
                                           {1.0, 123.0},
                                           {2.0, 113.0},
                                           {6.0, 91.0},
                                           {12.0, 80.0},
                                           {18.0, 72.0}}};
constexpr std::array<AtAge, 4> kSystolic{
    {{0.0, 65.0}, {1.0 / 12.0, 80.0}, {1.0, 92.0}, {15.0, 120.0}}};
constexpr std::array<AtAge, 5> kHaemoglobin{
    {{0.0, 165.0}, {0.25, 115.0}, {1.0, 115.0}, {12.0, 135.0}, {18.0, 150.0}}};
constexpr std::array<AtAge, 3> kOpenWhenStill{{{0.0, 0.5}, {1.0, 0.5}, {6.0, 1.0}}};

double oxygenAsleep_mlPerMin(double weight_kg)
{
    constexpr double kHeaviestMeasured_kg = 25.0;
    const double grown = kUseAsleep * 10.0 * std::pow(weight_kg, 0.75);
    const double child = 5.0 * std::min(weight_kg, kHeaviestMeasured_kg) + 19.8;
    return std::max(grown, child);
}

/// Alveolar ventilation of quiet breathing, ml/min in the lungs.
double quietVentilation_mlPerMin(const PatientBuild& build)
{
    const BreathingPattern quiet = restingPattern(build);
    const Volume dead = healthySystem(build).anatomicalDeadSpace;
    return inMillilitres(quiet.tidalVolume - dead) * inPerMinute(quiet.rate);
}

double haemoglobin_gPerL(const PatientBuild& build)
{
    constexpr double kWoman = 135.0;
    const double man = atAge(kHaemoglobin, build.ageInYears);
    return build.sex == Sex::Female && build.ageInYears > 12.0 ? std::min(man, kWoman) : man;
}

double blood_ml(const PatientBuild& build)
{
    constexpr double kLean_mlPerKg = 70.0;
    constexpr double kInfant_mlPerKg = 80.0;
    constexpr double kFat_mlPerKg = 20.0;
    const double lean = std::min(build.weightInKilograms, lungWeight(build));
    const double perKg = build.ageInYears < 1.0 ? kInfant_mlPerKg : kLean_mlPerKg;
    return perKg * lean + kFat_mlPerKg * (build.weightInKilograms - lean);
}

} // namespace

BodyFigures bodyFiguresOf(const PatientBuild& build)
{
    constexpr double kOutputPerOxygen = 20.0;
    BodyFigures body;
    body.weight_kg = build.weightInKilograms;
    body.oxygenUse_mlPerS = oxygenAsleep_mlPerMin(body.weight_kg) / kUseAsleep / 60.0;
    body.carbonDioxide_mlPerS = kStandardPerBody * quietVentilation_mlPerMin(build) / 60.0
                                * kQuietCarbonDioxide_mmHg / kDryPressure_mmHg;
    body.cardiacOutput_mlPerS = kOutputPerOxygen * body.oxygenUse_mlPerS;
    body.bloodVolume_ml = blood_ml(build);
    body.haemoglobin_gPerL = haemoglobin_gPerL(build);
    body.heartRate_perMin = atAge(kHeartRate, build.ageInYears);
    const double systolic = atAge(kSystolic, build.ageInYears);
    body.pulse_mmHg = systolic / 3.0;
    body.mean_mmHg = systolic - 2.0 / 3.0 * body.pulse_mmHg;
    body.openWhenStill = atAge(kOpenWhenStill, build.ageInYears);
    body.restingVolume_ml = inMillilitres(lungVolumesOf(build).functionalResidual);
    return body;
}

} // namespace carina
