#pragma once

#include "engine/lungs/drawing/chest_shape.h"
#include "engine/lungs/mechanics/respiratory_fold.h"

#include <vector>

namespace carina::lab
{

/// A patient that breathes by the mechanics, and is drawn.
struct BreathingTrial {
    RespiratorySettings settings;
    double settle = 0.0; ///< seconds breathed before the first frame
    double seconds = 60.0;
    double framesPerSecond = 60.0;
};

/// One breath of a patient who breathes quietly by himself, after a minute of it, by when every
/// condition has come to rest; with its first frame and its last, which are alike, one more than
/// `frames`.
[[nodiscard]] BreathingTrial settledBreath(const PatientBuild& build,
                                           const LungCondition& condition, Frequency rate,
                                           double frames);

/// What the mechanics give to be drawn, frame by frame.
[[nodiscard]] std::vector<ChestShape> shapesOf(const BreathingTrial& trial);

/// Gas in both lungs.
[[nodiscard]] Volume gasOf(const ChestShape& shape);

} // namespace carina::lab
