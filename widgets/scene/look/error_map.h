#pragma once

#include "engine/geometry/vec.h"
#include "widgets/error_bands.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/scene_frame.h"

#include <optional>
#include <span>

namespace carina
{

/// The expected TRE, drawn as colour bands with isolines between them in place of the parts' own
/// colours. Each point has the error at the position where it is drawn, including breathing and
/// motion; tools keep their colours.
struct ErrorMap {
    Mat4 quadric_A = Mat4::Zero(); ///< [p 1] Q [p 1]^T is the mean squared TRE at p, m^2
    ErrorBands bands;              ///< of the RMS error, its square root
};

/// The range of the RMS error on the parts with `framed` set, at rest, with their bodies placed as
/// in the frame. On a flat triangle the largest value is at a vertex, because the quadric is
/// convex.
/// @returns std::nullopt if the frame draws none of them.
[[nodiscard]] std::optional<ErrorRange>
errorRange(const Mat4& quadric_A, std::span<const ScenePart> parts, const SceneFrame& frame);

} // namespace carina
