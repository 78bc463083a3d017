#include "engine/geometry/mesh/mesh_edges.h"

namespace carina
{

std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh)
{
    std::vector<EdgeUse> uses;
    uses.reserve(3 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k];
            const std::uint32_t to = t[(k + 1) % 3];
            uses.push_back({std::min(from, to), std::max(from, to), i, from < to});
        }
    }
    std::sort(uses.begin(), uses.end());
    return uses;
}

long excessForward(EdgeUseIterator first, EdgeUseIterator last)
{
    const long forward = std::count_if(first, last, [](const EdgeUse& u) { return u.forward; });
    return 2 * forward - (last - first);
}

} // namespace carina
