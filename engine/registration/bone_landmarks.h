#pragma once

#include "engine/geometry/vec.h"
#include "engine/registration/landmark_catalogue.h"

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

} // namespace carina
