#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// The five lobes of both lungs: a tapering body under the ribs, hollowed from below by the domes
/// of the diaphragm and from the middle by heart, great vessels and spine, and cut along the
/// fissures. The right lung is wider and sits on the higher dome; the left has the cardiac notch.
/// Fissures lie where each lobe has its share of the lung, and lobes keep half a millimetre apart
/// there.
///
/// @param outsideLungs distance in A to what no lung may enter
[[nodiscard]] std::vector<PartPlan> lobes(const BodyPlan& plan, const Implicit& outsideLungs);

/// Where bronchus and vessels enter a lung: it keeps its place when volumes are matched. In A.
[[nodiscard]] Vec3 hilum(Side side, const BodyPlan& plan);

} // namespace carina
