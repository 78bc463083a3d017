#pragma once

#include "engine/geometry/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace carina
{

/// Corner indices of one triangle, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle surface as it is drawn: single-precision positions in metres, in the frame whose
/// letter ends the name of the variable (mesh_A). Normals are of unit length and point outward, one
/// per vertex; or there are none.
struct TriangleMesh {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;
    std::vector<Triangle> triangles;

    [[nodiscard]] bool empty() const { return triangles.empty(); }
};

/// An axis-aligned box; empty where `min` is above `max` on any axis.
struct Box {
    Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void include(const Vec3& p)
    {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void include(const Box& other)
    {
        min = min.cwiseMin(other.min);
        max = max.cwiseMax(other.max);
    }
    [[nodiscard]] bool empty() const { return (min.array() > max.array()).any(); }
    [[nodiscard]] Vec3 centre() const { return 0.5 * (min + max); }
    [[nodiscard]] Vec3 size() const { return max - min; }
};

/// The smallest box around all vertices.
[[nodiscard]] Box boundsOf(const TriangleMesh& mesh);

/// Volume enclosed by a closed mesh, m^3, positive when the triangles face outward: the sum of the
/// signed tetrahedra p0 . (p1 x p2) / 6, in double precision, relative to the first vertex.
[[nodiscard]] double signedVolume(const TriangleMesh& mesh);

/// Angle-weighted vertex normals (Thuermer and Wuethrich 1998), replacing those of the mesh.
/// A vertex of no triangle, or of degenerate ones only, gets +z.
void computeNormals(TriangleMesh& mesh);

/// Appends `part` to `whole`. Normals are kept where both have them, and dropped otherwise.
void append(TriangleMesh& whole, const TriangleMesh& part);

} // namespace carina
