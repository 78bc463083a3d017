#include "engine/physiology/oxygen_dissociation.h"

namespace carina
{

double oxygenSaturation(double pressure_mmHg)
{
    constexpr double kCubic = 23400.0;
    constexpr double kLinear = 150.0;
    if (pressure_mmHg <= 0.0)
        return 0.0;
    const double power = pressure_mmHg * (pressure_mmHg * pressure_mmHg + kLinear);
    return power / (power + kCubic);
}

double oxygenContent_mlPerL(double pressure_mmHg, double haemoglobin_gPerL)
{
    constexpr double kBound_mlPerG = 1.36;
    constexpr double kDissolved_mlPerLmmHg = 0.031;
    return kBound_mlPerG * haemoglobin_gPerL * oxygenSaturation(pressure_mmHg)
           + kDissolved_mlPerLmmHg * pressure_mmHg;
}

double oxygenPressureOf(double content_mlPerL, double haemoglobin_gPerL)
{
    constexpr int kHalvings = 30;
    double below = 0.0;
    double above = 800.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (below + above);
        const bool isBelow = oxygenContent_mlPerL(middle, haemoglobin_gPerL) < content_mlPerL;
        (isBelow ? below : above) = middle;
    }
    return 0.5 * (below + above);
}

} // namespace carina
