#pragma once

#include "widgets/scene/labels/visible_places.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// A half line in A.
struct SightRay {
    Vec3 p_A_eye = Vec3::Zero();
    Vec3 dir_A = Vec3::UnitY(); ///< of length 1
};

/// A part that a ray meets, and where it meets it first.
struct PartOnRay {
    std::size_t part = 0; ///< index into the parts
    SurfacePlace place;
    double distance = 0.0; ///< from the eye, metres
};

/// The parts that a ray meets as a frame draws them, by their coarsest levels, the nearest first;
/// what is only a faint outline, as the skin is, comes after all others. What is cut away is not
/// there. Triangles are met from both sides (Moeller and Trumbore 1997).
/// @param shown the parts as drawn, without hidden ones
[[nodiscard]] std::vector<PartOnRay> partsOnRay(std::span<const ScenePart> shown,
                                                const SceneFrame& frame,
                                                const std::optional<Section>& section,
                                                const SightRay& ray);

/// The ray of a camera through a point of its picture, which is given right and down from the upper
/// left corner in fractions of its width and height.
[[nodiscard]] SightRay rayThrough(const QPointF& point, const SceneSight& sight);

} // namespace carina
