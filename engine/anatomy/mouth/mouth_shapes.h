#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// What is seen through the open mouth: tongue and vallecula, hard palate, soft palate with the
/// uvula, both arches with the tonsils between them, gums, lips, and the mucosa of mouth and
/// pharynx (throatLining). In Posture::Laryngoscopy the tongue lies on the mouth's floor behind the
/// lower teeth, as a blade holds it.
[[nodiscard]] std::vector<PartPlan> mouth(const BodyPlan& plan);

} // namespace carina
