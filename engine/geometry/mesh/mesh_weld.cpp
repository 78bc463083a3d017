#include "engine/geometry/mesh/mesh_weld.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace carina
{
namespace
{

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

/// A triangle by its vertices in ascending order, and whether its winding is an odd permutation.
struct SortedTriangle {
    Triangle corners;
    std::size_t place; ///< among the triangles of the mesh
    bool odd;

    friend auto operator<=>(const SortedTriangle&, const SortedTriangle&) = default;
};

SortedTriangle sorted(const Triangle& t, std::size_t place)
{
    Triangle corners = t;
    std::sort(corners.begin(), corners.end());
    const auto lowest = std::min_element(t.begin(), t.end()) - t.begin();
    return {corners, place, t[(lowest + 1) % 3] != corners[1]};
}

/// Triangles on the same three vertices: how many there are of either winding.
struct Stack {
    std::vector<SortedTriangle>::const_iterator first;
    std::ptrdiff_t even = 0;
    std::ptrdiff_t odd = 0;
};

std::vector<Stack> stacksOf(const std::vector<SortedTriangle>& triangles)
{
    std::vector<Stack> stacks;
    for (auto it = triangles.begin(); it != triangles.end(); ++it) {
        if (stacks.empty() || stacks.back().first->corners != it->corners)
            stacks.push_back({it});
        ++(it->odd ? stacks.back().odd : stacks.back().even);
    }
    return stacks;
}

/// Leaves at most one triangle on the same three vertices; keeps the order.
void dropRepeated(std::vector<Triangle>& triangles)
{
    std::vector<SortedTriangle> all;
    all.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        all.push_back(sorted(triangles[i], i));
    std::sort(all.begin(), all.end());
    const std::vector<Stack> stacks = stacksOf(all);
    const auto folds =
        std::count_if(stacks.begin(), stacks.end(), [](const Stack& s) { return s.even == s.odd; });
    const bool twoSided = 2 * folds > std::ssize(stacks);
    std::vector<bool> keep(triangles.size(), false);
    for (const Stack& s : stacks) {
        const bool odd = twoSided ? s.first->odd : s.odd > s.even;
        const auto kept = std::find_if(s.first, s.first + s.even + s.odd,
                                       [odd](const SortedTriangle& t) { return t.odd == odd; });
        keep[kept->place] = twoSided || s.even != s.odd;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (keep[i])
            triangles[count++] = triangles[i];
    triangles.resize(count);
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
    dropRepeated(result.triangles);
    dropUnusedVertices(result);
    return result;
}

} // namespace carina
