#pragma once

#include "engine/core/expects.h"
#include "engine/geometry/deformation/throat_formula.h"
#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina
{

/// A mesh whose places are displaced by pullAt(place), a DisplacementAt<float>, with its exact
/// normals n ~ cof(I + grad d) n0. @pre each place has a normal
template <class PullAt>
[[nodiscard]] TriangleMesh movedMesh(const TriangleMesh& mesh_A, const PullAt& pullAt)
{
    CARINA_EXPECTS(mesh_A.normals.size() == mesh_A.positions.size());
    TriangleMesh out = mesh_A;
    for (std::size_t i = 0; i < mesh_A.positions.size(); ++i) {
        const DisplacementAt<float> pull = pullAt(mesh_A.positions[i]);
        out.positions[i] += pull.d;
        out.normals[i] = turnedNormal<float>(pull.gradient, mesh_A.normals[i]);
    }
    return out;
}

} // namespace carina
