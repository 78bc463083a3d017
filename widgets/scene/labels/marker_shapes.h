#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <memory>

namespace carina
{

/// Shapes that mark places in a scene, closed and with normals, in a frame F of their own.

/// A ball about the origin.
[[nodiscard]] std::shared_ptr<const TriangleMesh> ballMarker(Length radius);
/// Two cones base to base about the origin, their tips along z, as high as they are wide.
[[nodiscard]] std::shared_ptr<const TriangleMesh> diamondMarker(Length radius);
/// A slim cone with its tip at the origin, that widens along +z.
[[nodiscard]] std::shared_ptr<const TriangleMesh> pointerMarker(Length length, Length radius);

} // namespace carina
