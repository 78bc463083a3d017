#pragma once

#include "engine/physiology/body_fold.h"

namespace carina::test
{

/// A body in the middle of its life: ten seconds after an induction, under a mask with oxygen.
inline BodyState livedBody()
{
    RespiratorySettings breathing;
    RespiratoryFold lungs{breathing};
    BodySettings settings;
    settings.build = {metres(1.75), 77.0, 40.0, Sex::Male};
    settings.gas = {1.0, true, true};
    BodyFold body{settings};
    body.give({DrugKind::Propofol, 150.0});
    body.give({DrugKind::Rocuronium, 50.0});
    for (int i = 1; i <= 5000; ++i) {
        lungs.step();
        if (i % kRespiratoryStepsPerBodyStep == 0)
            body.step(lungs);
    }
    return body.state();
}

} // namespace carina::test
