#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Seven cervical and twelve thoracic vertebrae: body, arch, spinous and transverse processes, with
/// thoracic kyphosis and cervical lordosis. The intervertebral discs are left out as gaps.
[[nodiscard]] std::vector<PartPlan> spine(const BodyPlan& plan);

/// The middle of the atlas, in A, metres: behind the pharynx, at the level of the hard palate.
[[nodiscard]] Vec3 atlasOf(const BodyPlan& plan);

} // namespace carina
