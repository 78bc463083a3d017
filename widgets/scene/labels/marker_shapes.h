#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <memory>

namespace carina
{

/// Closed meshes with normals that mark points in a scene, each in its own frame F, metres.

/// A ball about the origin.
[[nodiscard]] std::shared_ptr<const TriangleMesh> ballMarker(Length radius);
/// Two cones joined at their bases in the plane z = 0, their tips on the z axis, as high as wide.
[[nodiscard]] std::shared_ptr<const TriangleMesh> diamondMarker(Length radius);
/// A slim cone with its tip at the origin, widening along +z.
[[nodiscard]] std::shared_ptr<const TriangleMesh> pointerMarker(Length length, Length radius);

} // namespace carina
