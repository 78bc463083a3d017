#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// The five lobes of both lungs: a tapering body under the ribs, minus the domes of the diaphragm
/// below and heart, great vessels and spine in the middle, and cut along the fissures. The right
/// lung is wider and sits on the higher dome; the left one has the cardiac notch. Fissures are
/// placed so that each lobe has its share of the lung (LobeShares), and are half a millimetre wide.
///
/// @param outsideLungs signed distance in A, metres, to the region that the lungs must not enter
[[nodiscard]] std::vector<PartPlan> lobes(const BodyPlan& plan, const Implicit& outsideLungs);

/// The hilum, where bronchus and vessels enter a lung; in A, metres. It stays fixed when the lungs
/// are scaled to their volume.
[[nodiscard]] Vec3 hilum(Side side, const BodyPlan& plan);

} // namespace carina
