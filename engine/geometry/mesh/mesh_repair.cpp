#include "engine/geometry/mesh/mesh_repair.h"

#include "engine/geometry/mesh/mesh_edges.h"
#include "engine/geometry/mesh/mesh_weld.h"
#include "engine/geometry/mesh/mesh_winding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carina
{
namespace
{

constexpr std::size_t kMostEdgesTriangulated = 256;

/// One directed edge beside a hole.
struct HoleEdge {
    std::uint32_t from;
    std::uint32_t to;
};

/// The excess uses of edges, sorted by where they start.
std::vector<HoleEdge> holeEdges(const TriangleMesh& mesh)
{
    std::vector<HoleEdge> edges;
    forEachEdge(sortedEdgeUses(mesh), [&](EdgeUseIterator first, EdgeUseIterator last) {
        const long excess = excessForward(first, last);
        for (long i = 0; i < std::abs(excess); ++i)
            edges.push_back(excess > 0 ? HoleEdge{first->low, first->high}
                                       : HoleEdge{first->high, first->low});
    });
    std::stable_sort(edges.begin(), edges.end(),
                     [](const HoleEdge& a, const HoleEdge& b) { return a.from < b.from; });
    return edges;
}

double areaOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return 0.5 * (b - a).cross(c - a).norm();
}

/// The triangulation of least area of the polygon, as triangles of positions in the polygon.
std::vector<Triangle> leastAreaTriangulation(const std::vector<Vec3>& polygon)
{
    const auto n = static_cast<std::uint32_t>(polygon.size());
    std::vector<double> area(std::size_t{n} * n, 0.0);
    std::vector<std::uint32_t> apex(std::size_t{n} * n, 0);
    const auto at = [n](std::uint32_t i, std::uint32_t k) { return std::size_t{i} * n + k; };
    for (std::uint32_t span = 2; span < n; ++span) {
        for (std::uint32_t i = 0; i + span < n; ++i) {
            const std::uint32_t k = i + span;
            area[at(i, k)] = std::numeric_limits<double>::infinity();
            for (std::uint32_t m = i + 1; m < k; ++m) {
                const double sum =
                    area[at(i, m)] + area[at(m, k)] + areaOf(polygon[i], polygon[m], polygon[k]);
                if (sum < area[at(i, k)]) {
                    area[at(i, k)] = sum;
                    apex[at(i, k)] = m;
                }
            }
        }
    }
    std::vector<Triangle> triangles;
    std::vector<HoleEdge> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [i, k] = open.back();
        open.pop_back();
        if (k - i < 2)
            continue;
        const std::uint32_t m = apex[at(i, k)];
        triangles.push_back({i, m, k});
        open.push_back({i, m});
        open.push_back({m, k});
    }
    return triangles;
}

void cover(TriangleMesh& mesh, const BoundaryLoop& loop)
{
    std::vector<Vec3> polygon;
    for (const std::uint32_t v : loop)
        polygon.push_back(mesh.positions[v].cast<double>());
    if (loop.size() <= kMostEdgesTriangulated) {
        for (const Triangle& t : leastAreaTriangulation(polygon))
            mesh.triangles.push_back({loop[t[2]], loop[t[1]], loop[t[0]]});
        return;
    }
    const Vec3 mean = std::accumulate(polygon.begin(), polygon.end(), Vec3{Vec3::Zero()})
                      / static_cast<double>(polygon.size());
    const auto centre = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(mean.cast<float>());
    for (std::size_t i = 0; i < loop.size(); ++i)
        mesh.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], centre});
}

} // namespace

std::vector<BoundaryLoop> boundaryLoops(const TriangleMesh& mesh)
{
    const std::vector<HoleEdge> edges = holeEdges(mesh);
    std::vector<std::size_t> next(mesh.positions.size() + 1, edges.size());
    for (std::size_t i = edges.size(); i-- > 0;)
        next[edges[i].from] = i;
    std::vector<BoundaryLoop> loops;
    std::vector<bool> onPath(mesh.positions.size(), false);
    for (const HoleEdge& start : edges) {
        BoundaryLoop path;
        std::uint32_t v = start.from;
        while (next[v] < edges.size() && edges[next[v]].from == v) {
            onPath[v] = true;
            path.push_back(v);
            v = edges[next[v]++].to;
            if (!onPath[v])
                continue;
            const auto first = std::find(path.begin(), path.end(), v);
            for (auto it = first; it != path.end(); ++it)
                onPath[*it] = false;
            loops.emplace_back(first, path.end());
            path.erase(first, path.end());
        }
    }
    return loops;
}

TriangleMesh capped(const TriangleMesh& mesh)
{
    TriangleMesh result{mesh.positions, {}, mesh.triangles};
    for (const BoundaryLoop& loop : boundaryLoops(mesh))
        cover(result, loop);
    return result;
}

TriangleMesh closedSurface(const TriangleMesh& mesh, Length weldTolerance)
{
    return facingOutward(capped(consistentlyWound(welded(mesh, weldTolerance))));
}

} // namespace carina
