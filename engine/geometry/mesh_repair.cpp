#include "engine/geometry/mesh_repair.h"

#include "engine/core/expects.h"
#include "engine/geometry/mesh_edges.h"
#include "engine/geometry/mesh_winding.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace carina
{
namespace
{

constexpr std::size_t kMostEdgesTriangulated = 256;

struct Cell {
    std::int64_t x, y, z;
    friend bool operator==(const Cell&, const Cell&) = default;
};

struct CellHash {
    std::size_t operator()(const Cell& c) const
    {
        const auto mix = static_cast<std::uint64_t>(c.x) * 0x9e3779b97f4a7c15ULL
                         ^ static_cast<std::uint64_t>(c.y) * 0xc2b2ae3d27d4eb4fULL
                         ^ static_cast<std::uint64_t>(c.z) * 0x165667b19e3779f9ULL;
        return static_cast<std::size_t>(mix ^ mix >> 29);
    }
};

/// Finds the first vertex within the tolerance, by a grid of cells as wide as the tolerance.
class VertexWelder
{
public:
    explicit VertexWelder(double tolerance)
        : m_tolerance(tolerance),
          m_cellWidth(std::max(tolerance, 1e-9)),
          m_reach(tolerance > 0.0 ? 1 : 0)
    {
    }

    /// The index of `p` among the vertices kept so far; it is kept when it is new.
    std::uint32_t indexOf(const Vec3f& p)
    {
        const Cell home = cellOf(p);
        std::optional<std::uint32_t> found;
        for (std::int64_t x = home.x - m_reach; x <= home.x + m_reach; ++x)
            for (std::int64_t y = home.y - m_reach; y <= home.y + m_reach; ++y)
                for (std::int64_t z = home.z - m_reach; z <= home.z + m_reach; ++z)
                    findIn({x, y, z}, p, found);
        if (found)
            return *found;
        m_positions.push_back(p);
        m_grid.emplace(home, static_cast<std::uint32_t>(m_positions.size() - 1));
        return static_cast<std::uint32_t>(m_positions.size() - 1);
    }

    std::vector<Vec3f> takePositions() { return std::move(m_positions); }

private:
    void findIn(const Cell& cell, const Vec3f& p, std::optional<std::uint32_t>& found) const
    {
        const auto [first, last] = m_grid.equal_range(cell);
        for (auto it = first; it != last; ++it) {
            const Vec3f& other = m_positions[it->second];
            if ((p - other).cast<double>().norm() <= m_tolerance)
                found = std::min(found.value_or(it->second), it->second);
        }
    }

    Cell cellOf(const Vec3f& p) const
    {
        const auto along = [&](float x) {
            return static_cast<std::int64_t>(std::floor(static_cast<double>(x) / m_cellWidth));
        };
        return {along(p.x()), along(p.y()), along(p.z())};
    }

    double m_tolerance;
    double m_cellWidth;
    std::int64_t m_reach; ///< cells to each side that may hold a vertex within the tolerance
    std::vector<Vec3f> m_positions;
    std::unordered_multimap<Cell, std::uint32_t, CellHash> m_grid;
};

/// Removes all but the first of triangles on the same three vertices; keeps the order.
void dropDuplicates(std::vector<Triangle>& triangles)
{
    std::vector<std::pair<Triangle, std::size_t>> corners;
    corners.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        Triangle sorted = triangles[i];
        std::sort(sorted.begin(), sorted.end());
        corners.emplace_back(sorted, i);
    }
    std::sort(corners.begin(), corners.end());
    std::vector<bool> keep(triangles.size(), false);
    for (std::size_t i = 0; i < corners.size(); ++i)
        keep[corners[i].second] = i == 0 || corners[i].first != corners[i - 1].first;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (keep[i])
            triangles[kept++] = triangles[i];
    triangles.resize(kept);
}

/// Removes the vertices that no triangle uses; keeps the order.
void dropUnusedVertices(TriangleMesh& mesh)
{
    constexpr std::uint32_t kUnused = 0xffffffff;
    std::vector<std::uint32_t> newIndex(mesh.positions.size(), kUnused);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            newIndex[v] = 0;
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < newIndex.size(); ++v) {
        if (newIndex[v] == kUnused)
            continue;
        mesh.positions[kept] = mesh.positions[v];
        newIndex[v] = kept++;
    }
    mesh.positions.resize(kept);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = newIndex[v];
}

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

TriangleMesh welded(const TriangleMesh& mesh, Length tolerance)
{
    CARINA_EXPECTS(tolerance.si >= 0.0);
    VertexWelder welder{tolerance.si};
    std::vector<std::optional<std::uint32_t>> newIndex(mesh.positions.size());
    TriangleMesh result;
    for (const Triangle& t : mesh.triangles) {
        Triangle u{};
        for (int k = 0; k < 3; ++k) {
            if (!newIndex[t[k]])
                newIndex[t[k]] = welder.indexOf(mesh.positions[t[k]]);
            u[k] = *newIndex[t[k]];
        }
        if (u[0] != u[1] && u[1] != u[2] && u[2] != u[0])
            result.triangles.push_back(u);
    }
    result.positions = welder.takePositions();
    dropDuplicates(result.triangles);
    dropUnusedVertices(result);
    return result;
}

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
