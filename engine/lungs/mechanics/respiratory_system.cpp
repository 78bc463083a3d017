#include "engine/lungs/mechanics/respiratory_system.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr double kRightShare = 0.525; // Pulse
// Of a patient of 77 kg (Pulse); both lungs, and the wall alike, so that the system has half of it.
constexpr double kStandardWeight = 77.0;
constexpr Compliance kLungCompliance = litresPerCmH2O(0.2);
constexpr Pressure kRecoilAtRest = cmH2O(5.0);
/// Of a lung squeezed: what a pneumothorax leaves of the resting volume.
constexpr double kFloorShare = 0.25;
constexpr Pressure kLimbSpread = cmH2O(4.0); // 3 to 5
/// Of the span: gas moved that carries a lung to its other limb.
constexpr double kLimbShare = 0.25;
// Pulse: above the carina 1.125, bronchi 0.45 cmH2O s/L.
constexpr Resistance kUpperAirway = cmH2OSecondsPerLitre(1.125);
constexpr Resistance kBothBronchi = cmH2OSecondsPerLitre(0.45);
constexpr double kAnatomicalDeadSpace_mlPerKg = 2.2;
constexpr double kInfantsDeadSpace_mlPerKg = 3.0; // textbooks
constexpr Frequency kRelief = hertz(0.5);
// The mediastinum: 35 mm at the most over an area of 200 cm2, reached at 14 cmH2O.
constexpr Volume kMediastinumMost = litres(0.7);
constexpr Compliance kMediastinum = litresPerCmH2O(0.05);

/// Resistance at an age over an adult's: the total at 4 Hz falls from 13 cmH2O s/L at 2 years to 3
/// at 18 (Pediatr Pulmonol 1985;1:134), taken as a geometric fall that goes on to the adult's. A
/// newborn's is 26 (20 to 30 in textbooks), with a geometric fall up to 2 years.
double narrownessAt(double years)
{
    const Resistance adult = kUpperAirway + kBothBronchi;
    const double young = 26.0 * std::pow(0.5, years / 2.0);
    const double older = 13.0 * std::pow(3.0 / 13.0, (years - 2.0) / 16.0);
    const Resistance atAge = cmH2OSecondsPerLitre(years < 2.0 ? young : older);
    return std::max(1.0, atAge / adult);
}

double quietRate_perMin(double years)
{
    if (years < 2.0)
        return 26.0 + 9.0 * (2.0 - years);
    const double young = 19.0 + 0.7 * (12.0 - years);
    const double grown = 16.0 + 0.5 * (18.0 - years);
    return std::max(years < 12.0 ? young : grown, 16.0);
}

/// Compliances over those of older people of the same weight. The chest wall of term newborns has
/// 4.2 ml/cmH2O per kilogram (Acta Paediatr Scand 1980;69:359) to the 2.6 of lung and wall here,
/// and is 2.86 (1.06) times as compliant as the lung below one year and 1.33 (0.36) times up to
/// three and a half (Papastamelos et al., J Appl Physiol 1995;78:179).
struct Softness {
    double lung;
    double wall;
};
Softness softnessAt(double years)
{
    constexpr double kLungAtBirth = 0.5;
    constexpr double kWallAtBirth = 1.62;
    constexpr double kUntil_years = 3.0;
    const double grown = std::min(years / kUntil_years, 1.0);
    return {std::lerp(kLungAtBirth, 1.0, grown), std::lerp(kWallAtBirth, 1.0, grown)};
}

double deadSpace_mlPerKg(double years)
{
    return std::lerp(kInfantsDeadSpace_mlPerKg, kAnatomicalDeadSpace_mlPerKg,
                     std::min(years / kSchoolAge_years, 1.0));
}

LungMechanics healthyLung(const LungVolumes& both, double share, double size,
                          const Softness& softness, double narrowness)
{
    const Volume rest = share * both.functionalResidual;
    const Compliance compliance = share * size * kLungCompliance;
    LungMechanics lung;
    lung.curve = PressureVolumeCurve::through(kFloorShare * rest, share * both.totalCapacity, rest,
                                              kRecoilAtRest, softness.lung * compliance);
    lung.limbSpread = kLimbSpread;
    lung.limbVolume = kLimbShare * lung.curve.span;
    lung.bronchi = {share / (narrowness * kBothBronchi.si)};
    lung.wall = softness.wall * compliance;
    lung.wallVolume = rest;
    lung.wallRecoil = kRecoilAtRest;
    lung.relief = kRelief;
    return lung;
}

/// Calls visit(number, number) on every pair of figures of two lungs or systems.
template <class Visit> void eachFigure(LungMechanics& a, const LungMechanics& b, Visit visit)
{
    visit(a.curve.floor.si, b.curve.floor.si);
    visit(a.curve.span.si, b.curve.span.si);
    visit(a.curve.centre.si, b.curve.centre.si);
    visit(a.curve.width.si, b.curve.width.si);
    visit(a.limbSpread.si, b.limbSpread.si);
    visit(a.limbVolume.si, b.limbVolume.si);
    visit(a.bronchi.si, b.bronchi.si);
    visit(a.compression, b.compression);
    visit(a.closing.si, b.closing.si);
    visit(a.wall.si, b.wall.si);
    visit(a.wallVolume.si, b.wallVolume.si);
    visit(a.wallRecoil.si, b.wallRecoil.si);
    visit(a.drive, b.drive);
    visit(a.pleuralGas.si, b.pleuralGas.si);
    visit(a.valve.si, b.valve.si);
    visit(a.relief.si, b.relief.si);
    visit(a.uptake.si, b.uptake.si);
    visit(a.uptakeEnd.si, b.uptakeEnd.si);
    visit(a.alveolarDeadSpace.si, b.alveolarDeadSpace.si);
}

template <class Visit>
void eachFigure(RespiratorySystem& a, const RespiratorySystem& b, Visit visit)
{
    for (std::size_t lung = 0; lung < a.lungs.size(); ++lung)
        eachFigure(a.lungs[lung], b.lungs[lung], visit);
    visit(a.upperLaminar.si, b.upperLaminar.si);
    visit(a.upperTurbulent, b.upperTurbulent);
    visit(a.mediastinum.si, b.mediastinum.si);
    visit(a.mediastinumMost.si, b.mediastinumMost.si);
    visit(a.mediastinalWeight.si, b.mediastinalWeight.si);
    visit(a.anatomicalDeadSpace.si, b.anatomicalDeadSpace.si);
    visit(a.effort, b.effort);
    visit(a.strength, b.strength);
    visit(a.inspiratoryRatio, b.inspiratoryRatio);
    visit(a.sag, b.sag);
}

} // namespace

RespiratorySystem healthySystem(const PatientBuild& build)
{
    CARINA_EXPECTS(build.height.si > 0.0 && build.weightInKilograms > 0.0);
    CARINA_EXPECTS(build.ageInYears >= 0.0);
    const LungVolumes volumes = lungVolumesOf(build);
    const double size = lungWeight(build) / kStandardWeight;
    const double narrowness = narrownessAt(build.ageInYears);
    const Softness softness = softnessAt(build.ageInYears);
    RespiratorySystem system;
    system.lungs = {healthyLung(volumes, kRightShare, size, softness, narrowness),
                    healthyLung(volumes, 1.0 - kRightShare, size, softness, narrowness)};
    system.upperLaminar = narrowness * kUpperAirway;
    system.mediastinum = size * kMediastinum;
    system.mediastinumMost = size * kMediastinumMost;
    system.anatomicalDeadSpace =
        millilitres(deadSpace_mlPerKg(build.ageInYears) * lungWeight(build));
    return system;
}

BreathingPattern restingPattern(const PatientBuild& build)
{
    const double perMin = quietRate_perMin(build.ageInYears);
    return {perMinute(perMin), millilitres(7.0 * usualWeight(build)),
            std::min(0.0125 * (perMin + 4.0) + 0.125, 0.5)};
}

Volume largestTidalVolume(const PatientBuild& build)
{
    const LungVolumes volumes = lungVolumesOf(build);
    return 0.5 * (volumes.totalCapacity - volumes.functionalResidual);
}

void relax(RespiratorySystem& system, double rest)
{
    constexpr double kCompliance = 0.4;
    for (LungMechanics& lung : system.lungs) {
        const Compliance before = lung.curve.complianceAt(lung.wallVolume);
        const Volume lost = (1.0 - rest) * lung.wallVolume;
        lung.wallVolume = lung.wallVolume - lost;
        lung.wallRecoil = lung.wallRecoil + Pressure{lost.si / lung.wall.si};
        lung.curve =
            PressureVolumeCurve::through(lung.curve.floor, lung.curve.floor + lung.curve.span,
                                         lung.wallVolume, lung.wallRecoil, kCompliance * before);
    }
}

void intubate(RespiratorySystem& system, Length innerDiameter)
{
    CARINA_EXPECTS(innerDiameter.si > 0.0);
    constexpr double kViscosity = 1.85e-5; // Pa s, of air
    constexpr double kDensity = 1.2;       // kg/m^3
    constexpr double kTubeLength = 0.3;    // m
    constexpr double kEndLosses = 1.5;
    constexpr double kReferenceFlow = 1e-3; // m^3/s
    const double d = innerDiameter.si;
    const double area = std::numbers::pi * d * d / 4.0;
    const double reynolds = kDensity * kReferenceFlow * d / (area * kViscosity);
    const double friction = 0.316 / std::pow(reynolds, 0.25);
    system.upperLaminar = {128.0 * kViscosity * kTubeLength / (std::numbers::pi * d * d * d * d)};
    system.upperTurbulent =
        0.5 * kDensity / (area * area) * (friction * kTubeLength / d + kEndLosses);
    system.anatomicalDeadSpace = 0.5 * system.anatomicalDeadSpace;
}

void approach(RespiratorySystem& system, const RespiratorySystem& target, double share)
{
    eachFigure(system, target,
               [share](double& figure, double end) { figure += share * (end - figure); });
}

} // namespace carina
