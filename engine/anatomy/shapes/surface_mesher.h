#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"
#include "engine/core/units.h"

namespace carina
{

/// The surface of a solid as a closed mesh that faces outward, by OpenVDB's dual contouring on a
/// grid of cubes of edge `voxel`. Edges sharper than a voxel are rounded. The mesh has no normals.
///
/// Around a fine place the cubes are smaller: the grid is drawn together there, and evenly.
///
/// @pre voxel is above zero and the surface lies inside the shape's bounds; the fine place has a
///      share above 0 and at most 1, and a reach above 0.
[[nodiscard]] TriangleMesh meshOf(const ImplicitShape& shape, Length voxel,
                                  const FinePlace& fine = {});

} // namespace carina
