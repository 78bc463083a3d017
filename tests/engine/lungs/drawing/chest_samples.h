#pragma once

#include "engine/lungs/mechanics/lung_dynamics.h"

namespace carina::test
{

/// Both lungs together: a compliance in L/cmH2O and a resistance in cmH2O s/L.
struct LinearChest {
    double lungCompliance = 0.1;
    double wallCompliance = 0.1;
    double upper = 2.0;
    double bronchi = 4.0;
    double rightShare = 0.5;
};

/// Lungs so large that their curves are straight where they are used, without loops; at rest they
/// hold what they rest at with a recoil of 5 cmH2O.
inline RespiratorySystem linear(const LinearChest& chest)
{
    constexpr double kLarge_l = 1e6; // of the span
    RespiratorySystem system;
    for (std::size_t i = 0; i < 2; ++i) {
        const double share = i == 0 ? chest.rightShare : 1.0 - chest.rightShare;
        LungMechanics& lung = system.lungs[i];
        const Volume rest = share * litres(2.4);
        lung.curve = PressureVolumeCurve::through(rest - litres(0.5 * kLarge_l),
                                                  rest + litres(0.5 * kLarge_l), rest, cmH2O(5.0),
                                                  litresPerCmH2O(share * chest.lungCompliance));
        lung.limbVolume = litres(1.0);
        lung.bronchi = {share / cmH2OSecondsPerLitre(chest.bronchi).si};
        lung.wall = litresPerCmH2O(share * chest.wallCompliance);
        lung.wallVolume = rest;
        lung.wallRecoil = cmH2O(5.0);
    }
    system.upperLaminar = cmH2OSecondsPerLitre(chest.upper);
    return system;
}

inline double gasAboveRest_l(const RespiratorySystem& system, const ChestContent& content)
{
    return inLitres(content[0].gas - system.lungs[0].wallVolume + content[1].gas
                    - system.lungs[1].wallVolume);
}

inline constexpr std::array<Pressure, 3> kRelaxed{};

inline constexpr double kStep = 2e-3;              // s
inline constexpr double kVolumeTolerance_l = 1e-6; // of a straight curve and a step of kStep
inline constexpr double kPressureTolerance_cmH2O = 1e-5;

inline AirwayOpening openTo(double p_cmH2O) { return AirwayOpening::at(cmH2O(p_cmH2O)); }

/// So many steps with the muscles relaxed and the opening held.
inline ChestContent held(const RespiratorySystem& system, ChestContent content,
                         const AirwayOpening& opening, int steps, double step)
{
    for (int i = 0; i < steps; ++i)
        content = advanced(system, content, kRelaxed, opening, step);
    return content;
}

} // namespace carina::test
