#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"

#include <QJsonObject>

#include <optional>

namespace carina::lab
{

/// The patient at rest, and what each condition makes of five minutes and half an hour of
/// spontaneous breathing and of a minute of volume control, at the severities 0.3, 0.6 and 0.9,
/// beside the ranges that are published. The keys are in the help of `mechanics`.
/// @param healthy who breathes, and how; spontaneous
/// @param drawnRest what the lungs enclose that are drawn of this patient at rest
/// @param only      the one condition to describe; all where there is none
[[nodiscard]] QJsonObject mechanicsTable(const RespiratorySettings& healthy, Volume drawnRest,
                                         std::optional<ConditionKind> only);

} // namespace carina::lab
