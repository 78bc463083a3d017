#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <array>
#include <vector>

namespace carina
{

/// Landmarks of a patient's ribs and sternum, in A, metres.
struct RibLandmarks {
    /// The middle of each rib where bone becomes cartilage, first rib first.
    std::array<Vec3, 12> p_A_leftEnds;
    std::array<Vec3, 12> p_A_rightEnds;
    Vec3 p_A_sternalNotch = Vec3::Zero(); ///< upper edge of the manubrium in the midline
    Vec3 p_A_xiphoidTip = Vec3::Zero();
};

/// The landmarks of a patient.
[[nodiscard]] RibLandmarks ribLandmarksOf(const BodyPlan& plan);

/// Twelve pairs of ribs, seven pairs of costal cartilages, manubrium, body of the sternum, xiphoid
/// process and both clavicles. Each rib runs from the spine backwards, around the side and down to
/// the front.
[[nodiscard]] std::vector<PartPlan> ribCage(const BodyPlan& plan);

/// Centre line of a left rib (0 is the first), in reference millimetres of the chest (BodyPlan).
[[nodiscard]] std::vector<Vec3> ribLine(std::size_t rib);

} // namespace carina
