#pragma once

#include "engine/geometry/vec.h"
#include "widgets/error_bands.h"
#include "widgets/scene/surfaces/scene_part.h"
#include "widgets/scene/view/scene_frame.h"

#include <optional>
#include <span>

namespace carina
{

/// How far off what is drawn may be, as bands of colour with lines between them in place of the
/// parts' own colours. Each place has the error of where it is drawn, breathing or moved or not;
/// tools look as ever.
struct ErrorMap {
    Mat4 quadric_A = Mat4::Zero(); ///< [p 1] Q [p 1]^T is the mean squared error at p, m^2
    ErrorBands bands;              ///< of its root
};

/// Between which values the root of the mean squared error lies on the parts that a view frames,
/// where the frame has their bodies, at rest. On flat triangles the largest is at a vertex, for the
/// quadric is convex.
/// @returns nothing where the frame draws none of them.
[[nodiscard]] std::optional<ErrorRange>
errorRange(const Mat4& quadric_A, std::span<const ScenePart> parts, const SceneFrame& frame);

} // namespace carina
