#pragma once

#include "engine/geometry/vec.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// The surface of one bone of a patient, in A.
struct Bone {
    std::string name; ///< such as "Left fifth rib"
    std::span<const Vec3f> positions_A;
};

/// The four landmarks of ribCageCatalogue on a patient that has bones:
///
///     sternal notch         the highest point of the manubrium within 3 mm of its middle plane
///     xiphoid process       the lowest point of the xiphoid process
///     left, right fifth rib the foremost point of the rib within 3 mm of the plane through the
///                           middle of its clavicle, or of the whole rib where it ends before
///
/// Bones are known by their names: "manubrium", "xiphoid", "fifth rib" and "clavicle" with "left"
/// or "right", in letters of any case.
/// @param anatomy content hash of the patient
/// @returns nothing where one of these bones is missing.
[[nodiscard]] std::optional<LandmarkCatalogue> boneLandmarks(std::span<const Bone> bones,
                                                             std::string anatomy);

/// Further places taken from bones where a patient has them:
///
///     angle of the jaw   the point of the mandible's half that lies furthest down and back, the
///                        mouth shut
///     end of tenth rib   its foremost point
///
/// Known by "mandible" and "tenth rib" with "left" or "right". @param places those that stay where
/// a bone is missing
[[nodiscard]] FurtherPlaces onBones(FurtherPlaces places, std::span<const Bone> bones);

/// Places to check a registration at, none of them a landmark: the inner ends of both clavicles,
/// their points nearest to the middle of the manubrium. None where one of these bones is missing.
[[nodiscard]] std::vector<Landmark> boneCheckPlaces(std::span<const Bone> bones);

} // namespace carina
