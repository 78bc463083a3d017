#pragma once

#include "engine/lungs/mechanics/lung_condition.h"

namespace carina::test
{

inline constexpr double kSeverities[] = {0.1, 0.3, 0.6, 0.9, 1.0};

inline RespiratorySystem healthy() { return healthySystem({}); }

inline RespiratorySystem with(ConditionKind kind, double severity,
                              ConditionSide side = ConditionSide::Both)
{
    return afflicted(healthy(), kind == ConditionKind::Normal
                                    ? LungConditions{}
                                    : LungConditions{{kind, severity, side}});
}

} // namespace carina::test
