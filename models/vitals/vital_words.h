#pragma once

#include "models/vitals/vitals_model.h"

#include <QString>

namespace carina
{

/// "SpO2 below 85 %", with the limit that was passed.
[[nodiscard]] QString alarmText(const VitalAlarms::Active& alarm, const AlarmLimits& limits);
/// "high priority".
[[nodiscard]] QString priorityText(AlarmPriority priority);
/// "Oximeter tone".
[[nodiscard]] QString soundText(SoundKind kind);
/// What the stethoscope hears: "right lung, heart, wheezing"; "nothing is heard here"; empty off
/// the chest.
[[nodiscard]] QString heardText(const VitalsModel::Heard& heard);

} // namespace carina
