#include "engine/physiology/lung_faults.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kAwakeShunt = 0.02;
constexpr double kRelaxedShunt = 0.06;
constexpr double kMostShunt = 0.9;

/// Share of the blood of an affected lung that this condition keeps from the gas.
double shuntBy(const LungCondition& condition)
{
    const double severity = condition.severity;
    switch (condition.kind) {
    case ConditionKind::Ards:
        return 0.4 * severity;
    case ConditionKind::Asthma:
        return 0.1 * severity;
    case ConditionKind::Copd:
        return 0.08 * severity;
    case ConditionKind::Atelectasis:
        return 0.5 * 0.9 * severity;
    case ConditionKind::SimplePneumothorax:
        return 0.5 * 0.75 * severity;
    case ConditionKind::Normal:
    case ConditionKind::TensionPneumothorax:
    case ConditionKind::MainstemIntubation:
    case ConditionKind::Obstruction:
    case ConditionKind::StiffChest:
        return 0.0;
    }
    return 0.0;
}

bool isOn(const LungCondition& condition, std::size_t lung)
{
    return condition.side == ConditionSide::Both
           || (condition.side == ConditionSide::Right) == (lung == 0);
}

/// Share of a lung that gas in its pleura closes.
double closedByTension(const RespiratoryFold& breathing, std::size_t lung)
{
    const Volume rest = breathing.system().lungs[lung].wallVolume;
    return std::clamp(breathing.content()[lung].trapped / rest, 0.0, 1.0 - kLeastOpenShare);
}

} // namespace

std::array<double, 2> shuntOf(const LungConditions& conditions, const RespiratoryFold& breathing,
                              bool isRelaxed)
{
    std::array<double, 2> shunt{};
    for (std::size_t i = 0; i < 2; ++i) {
        double exposed = 1.0 - (isRelaxed ? kRelaxedShunt : kAwakeShunt);
        for (const LungCondition& condition : conditions)
            if (isOn(condition, i))
                exposed *= 1.0 - shuntBy(condition);
        exposed *= 1.0 - 0.5 * closedByTension(breathing, i);
        shunt[i] = std::min(kMostShunt, 1.0 - exposed);
    }
    return shunt;
}

std::array<double, 2> wastedOf(const RespiratoryFold& breathing)
{
    constexpr double kMost = 0.6;
    std::array<double, 2> wasted{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Volume dead = breathing.system().lungs[i].alveolarDeadSpace;
        const Volume gas = breathing.content()[i].gas;
        wasted[i] = gas > Volume{} ? std::clamp(dead / gas, 0.0, kMost) : kMost;
    }
    return wasted;
}

double slantOf(const LungMechanics& lung, double obstruction)
{
    constexpr double kMost = 0.8;
    constexpr double kHalf_s = 1.0;
    constexpr double kByTube = 0.3;
    if (lung.bronchi < kShut)
        return 0.0;
    const double time =
        lung.compression / lung.bronchi.si * lung.curve.complianceAt(lung.wallVolume).si;
    return std::min(kMost, kMost * time / (time + kHalf_s) + kByTube * obstruction);
}

double passingShare(const TubePlace& tube, double exhaled)
{
    return (1.0 - tube.leak) * (1.0 - tube.obstruction * (1.0 - 0.6 * exhaled));
}

Volume trappedGas(const RespiratoryFold& breathing)
{
    return breathing.content()[0].trapped + breathing.content()[1].trapped;
}

} // namespace carina
