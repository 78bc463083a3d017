#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <random>
#include <vector>

namespace carina::test
{

/// Two triangles, vertices at these places, and normals to all sides.
/// @pre at least four places
inline TriangleMesh meshOf(const std::vector<Vec3>& places_A)
{
    std::mt19937 random{11};
    std::normal_distribution<float> number;
    TriangleMesh mesh;
    for (const Vec3& p_A : places_A) {
        mesh.positions.emplace_back(p_A.cast<float>());
        mesh.normals.push_back(Vec3f{number(random), number(random), number(random)}.normalized());
    }
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
    return mesh;
}

} // namespace carina::test
