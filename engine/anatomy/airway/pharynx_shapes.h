#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// The wall of the pharynx, open to the front, from the base of the skull to the cricoid, as its
/// three constrictor muscles; and the oesophagus from there, behind the trachea, to the diaphragm.
[[nodiscard]] std::vector<PartPlan> pharynxAndOesophagus(const BodyPlan& plan);

} // namespace carina
