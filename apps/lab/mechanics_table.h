#pragma once

#include "engine/lungs/respiratory_system.h"

#include <QJsonObject>

namespace carina::lab
{

/// The patient at rest, and what each condition makes of quiet breathing and of volume control
/// after a minute, at the severities 0.3, 0.6 and 0.9. The keys are in the help of `mechanics`.
[[nodiscard]] QJsonObject mechanicsTable(const PatientBuild& build);

} // namespace carina::lab
