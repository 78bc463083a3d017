#include "engine/geometry/mesh/triangle_mesh.h"

#include <cmath>

namespace carina
{

Box boundsOf(const TriangleMesh& mesh)
{
    Box box;
    for (const Vec3f& p : mesh.positions)
        box.include(p.cast<double>());
    return box;
}

double signedVolume(const TriangleMesh& mesh)
{
    if (mesh.positions.empty())
        return 0.0;
    const Vec3 origin = mesh.positions.front().cast<double>();
    double sixfold = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]].cast<double>() - origin;
        const Vec3 b = mesh.positions[t[1]].cast<double>() - origin;
        const Vec3 c = mesh.positions[t[2]].cast<double>() - origin;
        sixfold += a.dot(b.cross(c));
    }
    return sixfold / 6.0;
}

void computeNormals(TriangleMesh& mesh)
{
    std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
    for (const Triangle& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = mesh.positions[t[k]].cast<double>();
            const Vec3 e1 = mesh.positions[t[(k + 1) % 3]].cast<double>() - p;
            const Vec3 e2 = mesh.positions[t[(k + 2) % 3]].cast<double>() - p;
            const Vec3 cross = e1.cross(e2);
            const double twiceArea = cross.norm();
            if (twiceArea > 0.0)
                sums[t[k]] += std::atan2(twiceArea, e1.dot(e2)) / twiceArea * cross;
        }
    }
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double length = sums[i].norm();
        mesh.normals[i] = length > 0.0 ? Vec3f{(sums[i] / length).cast<float>()} : Vec3f::UnitZ();
    }
}

void append(TriangleMesh& whole, const TriangleMesh& part)
{
    const auto first = static_cast<std::uint32_t>(whole.positions.size());
    const bool keepNormals = whole.normals.size() == whole.positions.size()
                             && part.normals.size() == part.positions.size();
    whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
    if (keepNormals)
        whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
    else
        whole.normals.clear();
    whole.triangles.reserve(whole.triangles.size() + part.triangles.size());
    for (const Triangle& t : part.triangles)
        whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

} // namespace carina
