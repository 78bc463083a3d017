#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina::test
{

/// Edges that do not belong to exactly two triangles which run along it in opposite directions,
/// counted through a map and not through the code under test. 0 for a closed two-manifold.
int edgesWithoutPartner(const TriangleMesh& mesh);

/// Largest deviation of a vertex normal from unit length; 1e9 where normals are missing.
double worstNormalLength(const TriangleMesh& mesh);

/// A sphere as an octahedron whose triangles are split in four `splits` times: 8 * 4^splits
/// triangles, each with corners of its own as an STL file has them.
TriangleMesh unweldedSphere(double radius, int splits);

} // namespace carina::test
