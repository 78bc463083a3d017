#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"
#include "engine/core/units.h"

namespace carina
{

/// The surface of a solid as a closed mesh that faces outward, by OpenVDB's dual contouring on a
/// grid of cubes of edge `voxel`. Edges sharper than a voxel are rounded. The mesh has no normals.
///
/// @pre voxel is above zero and the surface lies inside the shape's bounds.
[[nodiscard]] TriangleMesh meshOf(const ImplicitShape& shape, Length voxel);

} // namespace carina
