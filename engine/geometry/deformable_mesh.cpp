#include "engine/geometry/deformable_mesh.h"

namespace carina
{

TriangleMesh deformed(const DeformableMesh& mesh, float s)
{
    TriangleMesh out;
    out.triangles = mesh.rest.triangles;
    out.positions.reserve(mesh.rest.positions.size());
    out.normals.reserve(mesh.rest.positions.size());
    for (std::size_t i = 0; i < mesh.rest.positions.size(); ++i) {
        out.positions.push_back(mesh.rest.positions[i] + s * mesh.displacement[i]);
        const Vec3f n =
            mesh.rest.normals[i] + s * (mesh.normalLinear[i] + s * mesh.normalQuadratic[i]);
        out.normals.push_back(n.normalized());
    }
    return out;
}

} // namespace carina
