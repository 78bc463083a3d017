#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/lungs/mechanics/body_position.h"

#include <QJsonObject>

#include <optional>

namespace carina::lab
{

/// Draws a patient in a position with every condition, at every severity, breathed in every way,
/// and says how far the volumes drawn were from the mechanics. The keys are in the help of
/// `breathe`.
/// @returns what drawBreathing does.
[[nodiscard]] Result<QJsonObject> sweepConditions(const Anatomy& anatomy, const PatientBuild& build,
                                                  BodyPosition position,
                                                  std::optional<std::size_t> level);

} // namespace carina::lab
