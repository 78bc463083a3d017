#pragma once

#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <span>
#include <vector>

namespace carina
{

/// A square marker on a body B, a tool of any role. Its own frame K has its origin in the middle of
/// the marker, +x to the right of the printed picture, +y up, and +z out of the paper.
struct BodyMarker {
    int id = 0;
    double side = 0.0; ///< of the black square, metres
    RigidTransform X_BK;
};

/// Its corners in B, as they go around the printed picture: upper left, upper right, lower right,
/// lower left.
[[nodiscard]] std::array<Vec3, 4> cornersOf(const BodyMarker& marker);

/// Markers that are fixed to each other.
using MarkerBody = std::vector<BodyMarker>;

/// @returns OutOfRange where a body has no marker or more than 64, one twice, an id beyond the
///          dictionary, or a marker smaller than 1 mm or larger than 1 m; the detail names it.
[[nodiscard]] Result<void> checkBody(std::span<const BodyMarker> body, int markersInDictionary);

} // namespace carina
