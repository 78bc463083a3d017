#pragma once

#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// The segmental bronchi: ten in the right lung and nine in the left, where the apical and the
/// posterior one of the upper lobe leave apart; each from its lobar bronchus into its segment.
[[nodiscard]] std::vector<PartPlan> segmentalBronchi(const BodyPlan& plan,
                                                     const AirwaySolid& airway);

} // namespace carina
