#include "engine/lungs/drawing/chest_shape.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kMediastinalArea = 0.02; // m^2, with 2.31 L at rest
constexpr Volume kAdultRest = litres(2.31);

double ribShareOf(const PatientBuild& build)
{
    constexpr double kChild = 0.45;
    const double grown = build.sex == Sex::Male ? 0.35 : 0.45;
    const double maturity = std::clamp((build.ageInYears - 12.0) / 6.0, 0.0, 1.0);
    return kChild + maturity * (grown - kChild);
}

} // namespace

ChestShape chestShape(const PatientBuild& build, const RespiratorySystem& system,
                      const ChestContent& content, const ChestMoment& moment)
{
    const RespiratorySystem healthy = healthySystem(build);
    const Volume rest = healthy.lungs[0].wallVolume + healthy.lungs[1].wallVolume;
    ChestShape shape;
    for (std::size_t i = 0; i < 2; ++i) {
        const Volume ofSide = healthy.lungs[i].wallVolume;
        const Volume held = content[i].gas + system.lungs[i].pleuralGas + content[i].trapped;
        const Volume given = (i == 0 ? 1.0 : -1.0) * moment.mediastinum;
        shape.lungs[i] = {content[i].gas, ofSide, held - given};
    }
    const double area = kMediastinalArea * std::pow(rest / kAdultRest, 2.0 / 3.0);
    shape.mediastinalShift = {moment.mediastinum.si / area};
    shape.sag = system.sag;
    shape.ribShare = ribShareOf(build);
    return shape;
}

} // namespace carina
