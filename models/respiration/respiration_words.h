#pragma once

#include "engine/lungs/mechanics/body_position.h"
#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/ventilation.h"

#include <QString>

namespace carina
{

[[nodiscard]] QString conditionText(ConditionKind kind);
[[nodiscard]] QString sideText(ConditionSide side);
[[nodiscard]] QString modeText(VentilationMode mode);
[[nodiscard]] QString positionText(BodyPosition position);

/// With its severity last, of which a place that is too narrow shows least: "COPD, both lungs,
/// severity 0.60"; "Normal".
[[nodiscard]] QString conditionText(const LungCondition& condition);
/// The same of several, with " + " between them; "Normal" of none.
[[nodiscard]] QString conditionText(const LungConditions& conditions);
/// "Volume control, PEEP 5 cmH2O"; "Spontaneous".
[[nodiscard]] QString ventilatorText(const VentilatorSettings& settings);

} // namespace carina
