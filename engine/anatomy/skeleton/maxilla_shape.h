#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// Both maxillae as one bone without the teeth: the alveolar arch that holds their roots, and the
/// bodies beside the nose, up to the floor of the orbits.
[[nodiscard]] PartPlan maxilla(const BodyPlan& plan);

/// Approximate signed distance to it, point and result in reference millimetres of the face.
[[nodiscard]] double maxillaDistance(const Vec3& p_mm);

} // namespace carina
