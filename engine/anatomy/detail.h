#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// One surface, finer and coarser.
struct LevelsOfDetail {
    std::vector<TriangleMesh> meshes; ///< finest first
    /// How far each of them departs from the first, as the quadric errors of its collapses tell
    /// together: the unit of the mesh; 0 for the first.
    std::vector<double> deviations;
};

/// Levels of detail of one surface, finest first, each with normals and ordered for the vertex
/// cache of a graphics card.
///
/// Level 0 is `finest` with vertices of equal position joined and triangles that then repeat a
/// corner left out, so that smoothing and closedness do not depend on how a file split its
/// vertices. Level k has about `shares[k - 1]` times the triangles of level 0, but not fewer than
/// 64 unless level 0 itself has fewer; edges are collapsed by quadric error (Garland and Heckbert
/// 1997). A collapse takes closed surfaces to closed surfaces, so every level is closed if `finest`
/// is; sheets that a collapse brings to touch along an edge are parted again. A mesh without a
/// proper triangle yields empty levels.
///
/// @pre each share lies in (0, 1] and none is larger than the one before it; every corner index is
///      a vertex of `finest`; positions are finite.
[[nodiscard]] LevelsOfDetail levelsOfDetail(TriangleMesh finest, std::span<const double> shares);

} // namespace carina
