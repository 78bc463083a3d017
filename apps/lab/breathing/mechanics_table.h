#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"

#include <QJsonObject>

namespace carina::lab
{

/// The patient at rest, and what each condition makes of a minute of breathing as set and of
/// volume control, at the severities 0.3, 0.6 and 0.9. The keys are in the help of `mechanics`.
/// @param healthy who breathes, and how; spontaneous
[[nodiscard]] QJsonObject mechanicsTable(const RespiratorySettings& healthy);

} // namespace carina::lab
