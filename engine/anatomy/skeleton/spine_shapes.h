#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Seven cervical and twelve thoracic vertebrae: body, arch, spinous and transverse processes. The
/// thorax has its curve to the back and the neck the other one; the discs are the gaps between.
[[nodiscard]] std::vector<PartPlan> spine(const BodyPlan& plan);

} // namespace carina
