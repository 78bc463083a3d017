#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"

namespace carina::test
{

inline constexpr int kMinute = 30000; // steps

inline RespiratorySettings settingsWith(VentilationMode mode, const LungCondition& condition)
{
    RespiratorySettings settings;
    settings.pattern = restingPattern(settings.build);
    settings.ventilator.mode = mode;
    settings.ventilator.pressureLimit = cmH2O(80.0);
    settings.tube = millimetres(mode == VentilationMode::Spontaneous ? 0.0 : 8.0);
    if (condition.kind != ConditionKind::Normal)
        settings.conditions = {condition};
    return settings;
}

inline RespiratoryFold after(int steps, const RespiratorySettings& settings)
{
    RespiratoryFold fold{settings};
    for (int i = 0; i < steps; ++i)
        fold.step();
    return fold;
}

inline BreathFigures under(VentilationMode mode, const LungCondition& condition)
{
    return after(kMinute / 3, settingsWith(mode, condition)).lastBreath();
}

inline LungCondition condition(ConditionKind kind, double severity)
{
    const bool oneSided =
        kind == ConditionKind::MainstemIntubation || kind == ConditionKind::SimplePneumothorax;
    return {kind, severity, oneSided ? ConditionSide::Right : ConditionSide::Both};
}

} // namespace carina::test
