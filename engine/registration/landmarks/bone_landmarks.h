#pragma once

#include "engine/geometry/vec.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// The surface of one bone of a patient.
struct Bone {
    std::string name;                   ///< such as "Left fifth rib"
    std::span<const Vec3f> positions_A; ///< its vertices, metres
};

/// The four landmarks of ribCageCatalogue, taken from the surfaces of a patient's bones:
///
///     sternal notch         the most superior point of the manubrium within 3 mm of its midplane
///     xiphoid process       the most inferior point of the xiphoid process
///     left, right fifth rib the most anterior point of the rib within 3 mm of the sagittal plane
///                           through the middle of the clavicle, or of the whole rib where it does
///                           not reach that plane
///
/// Bones are recognised by words in their names, in any case: "manubrium", "xiphoid", and
/// "fifth rib" and "clavicle" with "left" or "right".
/// @param anatomy content hash of the patient, stored in the catalogue
/// @returns nothing where one of these bones is missing.
[[nodiscard]] std::optional<LandmarkCatalogue> boneLandmarks(std::span<const Bone> bones,
                                                             std::string anatomy);

/// Further places, taken from the patient's bones where it has them:
///
///     angle of the jaw   the point of each half of the mandible with the largest y - z (down and
///                        back); the mouth has to be closed
///     end of tenth rib   its most anterior point
///
/// Recognised by "mandible", and "tenth rib" with "left" or "right".
/// @param places the result for places whose bone is missing
[[nodiscard]] FurtherPlaces onBones(FurtherPlaces places, std::span<const Bone> bones);

/// Places for checking a registration that are not landmarks:
///
///     larynx         the most anterior point of the thyroid cartilage (laryngeal prominence)
///     chin           where there is none: the most anterior point of the mandible
///     clavicles      the medial ends of both, their points nearest to the midplane of the
///                    manubrium
///
/// The first is at the height of the airway. Places whose bones are missing are left out.
[[nodiscard]] std::vector<Landmark> boneCheckPlaces(std::span<const Bone> bones);

} // namespace carina
