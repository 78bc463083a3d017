#pragma once

#include "engine/lungs/breathing_pattern.h"
#include "engine/lungs/respiratory_system.h"

#include <QJsonObject>

namespace carina::lab
{

/// The patient at rest, and what each condition makes of a minute of breathing and of volume
/// control by a pattern, at the severities 0.3, 0.6 and 0.9. The keys are in the help of
/// `mechanics`.
[[nodiscard]] QJsonObject mechanicsTable(const PatientBuild& build,
                                         const BreathingPattern& pattern);

} // namespace carina::lab
