#pragma once

#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// The segmental bronchi, each from its lobar bronchus into its segment: ten in the right lung and
/// nine in the left, where those of the apical and posterior upper lobe are separate.
[[nodiscard]] std::vector<PartPlan> segmentalBronchi(const BodyPlan& plan,
                                                     const AirwaySolid& airway);

} // namespace carina
