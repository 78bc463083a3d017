#include "tests/engine/anatomy/shapes/surface_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace carina::test
{

int edgesWithoutPartner(const TriangleMesh& mesh)
{
    struct Uses {
        int forth = 0;
        int back = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Uses> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            Uses& uses = edges[{std::min(a, b), std::max(a, b)}];
            ++(a < b ? uses.forth : uses.back);
        }
    }
    return static_cast<int>(std::count_if(edges.begin(), edges.end(), [](const auto& edge) {
        return edge.second.forth != 1 || edge.second.back != 1;
    }));
}

double worstNormalLength(const TriangleMesh& mesh)
{
    if (mesh.normals.size() != mesh.positions.size())
        return 1e9;
    double worst = 0.0;
    for (const Vec3f& n : mesh.normals)
        worst = std::max(worst, std::abs(n.cast<double>().norm() - 1.0));
    return worst;
}

namespace
{

void addSplit(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, double radius,
              int splits)
{
    if (splits > 0) {
        const Vec3 ab = (a + b).normalized();
        const Vec3 bc = (b + c).normalized();
        const Vec3 ca = (c + a).normalized();
        addSplit(mesh, a, ab, ca, radius, splits - 1);
        addSplit(mesh, ab, b, bc, radius, splits - 1);
        addSplit(mesh, ca, bc, c, radius, splits - 1);
        addSplit(mesh, ab, bc, ca, radius, splits - 1);
        return;
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : {a, b, c})
        mesh.positions.push_back((radius * p).cast<float>());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

} // namespace

TriangleMesh unweldedSphere(double radius, int splits)
{
    TriangleMesh mesh;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) {
                Vec3 a = x * Vec3::UnitX();
                Vec3 b = y * Vec3::UnitY();
                if (x * y * z < 0.0)
                    std::swap(a, b);
                addSplit(mesh, a, b, z * Vec3::UnitZ(), radius, splits);
            }
        }
    }
    return mesh;
}

} // namespace carina::test
