#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "evaluation/intubation/intubation_motion.h"
#include "evaluation/intubation/motion_parameters.h"

#include <QString>

#include <array>

namespace carina::lab
{

/// "trachea", as it stands in results.
[[nodiscard]] QString seatWord(TubeSeat seat);
/// "through_cords".
[[nodiscard]] QString stepWord(IntubationStep step);
/// What people do beside a recording, as the option --told names it: the step that it tells
/// (toldBy), or "breaths_end".
[[nodiscard]] QString toldWord(MotionAct act);
inline constexpr std::array kToldActs{MotionAct::CuffInflated, MotionAct::CuffDeflated,
                                      MotionAct::StyletOut, MotionAct::BreathsBegin,
                                      MotionAct::BreathsEnd};
/// All of these: "cuff_inflated, cuff_deflated".
[[nodiscard]] QString toldWords();
/// "right_mainstem".
[[nodiscard]] QString motionWord(MotionKind kind);

} // namespace carina::lab
