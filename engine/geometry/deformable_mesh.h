#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace carina
{

/// A mesh with one displacement mode, as the vertex shader resources/shaders/organ.vert draws it:
///
///     x(s) = x0 + s d              n(s) ~ n0 + s n1 + s^2 n2
///
/// s is a dimensionless amplitude, d in metres. With A = grad d the exact normal is the cofactor of
/// I + s A applied to n0, so n1 = tr(A) n0 - A^T n0 and n2 = cof(A) n0; both are stored unscaled.
struct DeformableMesh {
    TriangleMesh rest;                  ///< x0, n0 and the triangles
    std::vector<Vec3f> displacement;    ///< d, metres, one per vertex
    std::vector<Vec3f> normalLinear;    ///< n1, one per vertex
    std::vector<Vec3f> normalQuadratic; ///< n2, one per vertex
};

/// The mesh at amplitude s, computed in single precision exactly as the shader does. The CPU
/// reference of what is drawn.
[[nodiscard]] TriangleMesh deformed(const DeformableMesh& mesh, float s);

} // namespace carina
