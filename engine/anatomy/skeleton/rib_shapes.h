#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <array>
#include <vector>

namespace carina
{

/// Where the ribs of a patient end: points on the middle of each rib, in A.
struct RibLandmarks {
    std::array<Vec3, 12> p_A_leftEnds; ///< where bone becomes cartilage, first rib first
    std::array<Vec3, 12> p_A_rightEnds;
    Vec3 p_A_sternalNotch = Vec3::Zero(); ///< upper edge of the manubrium in the midline
    Vec3 p_A_xiphoidTip = Vec3::Zero();
};

[[nodiscard]] RibLandmarks ribLandmarksOf(const BodyPlan& plan);

/// Twelve pairs of ribs, seven pairs of costal cartilages, manubrium, body of the sternum, xiphoid
/// process and both clavicles. Each rib leaves the spine backwards, turns round the side and comes
/// down to the front.
[[nodiscard]] std::vector<PartPlan> ribCage(const BodyPlan& plan);

/// Middle line of a rib (0 the first) of the left side, in his millimetres.
[[nodiscard]] std::vector<Vec3> ribLine(std::size_t rib);

} // namespace carina
