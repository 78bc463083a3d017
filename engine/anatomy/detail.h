#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// One surface in several levels of detail.
struct LevelsOfDetail {
    std::vector<TriangleMesh> meshes; ///< finest first
    /// Deviation of each mesh from the first, in the unit of the mesh: the sum of the
    /// simplification errors (quadric error metric) up to it; 0 for the first.
    std::vector<double> deviations;
};

/// Levels of detail of one surface, finest first, each with normals and ordered for the vertex
/// cache of a graphics card.
///
/// Level 0 is `finest` with vertices of equal position merged and triangles that then repeat a
/// vertex removed, so that normals and closedness do not depend on how a file split its vertices.
/// Level k has about `shares[k - 1]` times the triangles of level 0, but not fewer than 64 unless
/// level 0 has fewer; edges are collapsed by quadric error (Garland and Heckbert 1997). Edge
/// collapse preserves closedness, so every level is closed if `finest` is. Sheets that a collapse
/// brings into contact along an edge are separated again. A mesh without a valid triangle gives
/// empty levels.
///
/// @pre each share lies in (0, 1] and none is larger than the one before it; all vertex indices of
///      `finest` are valid; positions are finite.
[[nodiscard]] LevelsOfDetail levelsOfDetail(TriangleMesh finest, std::span<const double> shares);

} // namespace carina
