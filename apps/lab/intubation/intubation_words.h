#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "evaluation/intubation/motion_parameters.h"

#include <QString>

namespace carina::lab
{

/// "trachea", as it stands in results.
[[nodiscard]] QString seatWord(TubeSeat seat);
/// "through_cords".
[[nodiscard]] QString stepWord(IntubationStep step);
/// "right_mainstem".
[[nodiscard]] QString motionWord(MotionKind kind);

} // namespace carina::lab
