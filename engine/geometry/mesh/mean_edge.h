#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>

namespace carina
{

/// The mean length of the first edges of triangles, which is near that of all; 0 of none.
[[nodiscard]] float meanEdge(std::span<const Triangle> triangles, std::span<const Vec3f> positions);

} // namespace carina
