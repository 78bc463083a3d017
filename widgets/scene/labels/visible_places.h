#pragma once

#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/orbit_camera.h"
#include "widgets/scene/view/scene_frame.h"

#include <QPointF>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// A camera and the section plane through which it sees a scene.
struct SceneSight {
    CameraPose pose;
    Frustum frustum;
    std::optional<Section> section{};
};

/// A point of a part's surface: a weighted mean of three corners of a triangle, so that it moves
/// with them.
struct SurfacePlace {
    std::array<Vec3, 3> corners_F; ///< in the frame of the part's body, before any deformation
    std::array<double, 3> weights{};
};

/// Where a camera sees a point: right and down from the upper left corner, as fractions of the
/// picture's width and height, and how far along the line of sight, metres.
struct SeenPoint {
    QPointF at;
    double depth = 0.0;
};

/// @returns std::nullopt for a point that is not in front of the near plane or outside the picture
[[nodiscard]] std::optional<SeenPoint> seenPoint(const Vec3& p_A, const SceneSight& sight);

/// Where a frame draws a point of a part: moved by breathing, by head and neck, by the jaw, by a
/// blade and by its body, and lifted out with its group.
/// @returns std::nullopt if the part's body is not drawn
[[nodiscard]] std::optional<Vec3> drawnAt(const ScenePart& part, const Vec3& p_F,
                                          const SceneFrame& frame);
[[nodiscard]] std::optional<Vec3> drawnAt(const ScenePart& part, const SurfacePlace& place,
                                          const SceneFrame& frame);

/// Whether a section cuts a point of a part away.
[[nodiscard]] bool isCutAway(const ScenePart& part, const Vec3& p_A,
                             const std::optional<Section>& section);

/// For each of some parts a place of its surface that a camera sees: inside the picture, not cut
/// away, and with no opaque part in front of it. Translucent parts hide nothing.
///
/// The parts are drawn in their coarsest levels into a depth buffer of kColumns columns (Catmull
/// 1974). Of the pixels in which a part is visible the place is in the one farthest from any pixel
/// in which it is not, so that it stays visible when the scene moves a little.
///
/// @param shown  the parts as drawn, without hidden ones
/// @param wanted indices into `shown`
/// @returns one place for each of `wanted`; std::nullopt for a part that is nowhere visible
[[nodiscard]] std::vector<std::optional<SurfacePlace>>
visiblePlaces(std::span<const ScenePart> shown, std::span<const std::size_t> wanted,
              const SceneFrame& frame, const SceneSight& sight);

} // namespace carina
