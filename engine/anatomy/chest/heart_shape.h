#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// The heart as two ventricles with a groove between them, two atria and their auricles, its apex
/// to the left, to the front and down; and the great vessels: aorta (ascending, arch over the left
/// main bronchus, descending to the diaphragm), both venae cavae, and the pulmonary trunk with its
/// two arteries as far as the hila. All are solid and begin within the heart.
///
/// @param airway signed distance in A, metres, to trachea and main bronchi, of which they keep
///               clear
[[nodiscard]] std::vector<PartPlan> heartAndVessels(const BodyPlan& plan, const Implicit& airway);

/// Signed distance in A to all of them together, metres: the lungs leave them free. Far away it is
/// only known to be more than 15 reference millimetres.
[[nodiscard]] Implicit heartAndVesselsRegion(const BodyPlan& plan);

} // namespace carina
