#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"

namespace carina::test
{

/// A fold in the middle of its life.
inline RespiratoryState livedRespiration()
{
    RespiratorySettings settings;
    settings.conditions = {{ConditionKind::TensionPneumothorax, 0.7, ConditionSide::Left}};
    settings.ventilator.mode = VentilationMode::PressureControl;
    RespiratoryFold fold{settings};
    for (int i = 0; i < 5000; ++i) {
        if (i == 1000 || i == 2500)
            fold.trigger(0.0);
        fold.step();
    }
    return fold.state();
}

} // namespace carina::test
