#include "engine/geometry/mesh/surface_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kLeaf = 6; ///< triangles at most

double squaredTo(const Box& box, const Vec3& p)
{
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm();
}

bool overlap(const Box& a, const Box& b)
{
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

std::array<Vec3, 3> arrayOf(const Corners& t) { return {t.a, t.b, t.c}; }

Box boxOf(const Corners& t)
{
    Box box;
    for (const Vec3& corner : arrayOf(t))
        box.include(corner);
    return box;
}

} // namespace

SurfaceTree::SurfaceTree(const TriangleMesh& mesh)
{
    std::vector<Item> items;
    items.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Box box = boxOf(cornersOf(mesh, t));
        items.push_back({box, box.centre(), std::uint32_t(items.size())});
    }
    if (!items.empty())
        build(items, 0, items.size());
    m_triangles.reserve(items.size());
    m_corners.reserve(items.size());
    for (const Item& item : items) {
        m_triangles.push_back(mesh.triangles[item.triangle]);
        m_corners.push_back(cornersOf(mesh, mesh.triangles[item.triangle]));
    }
}

/// Sorts the triangles from first to last and returns their node.
std::size_t SurfaceTree::build(std::vector<Item>& items, std::size_t first, std::size_t last)
{
    Node node{.box = {}, .first = first, .last = last};
    for (std::size_t i = first; i < last; ++i)
        node.box.include(items[i].box);
    if (last - first > kLeaf) {
        int axis = 0;
        node.box.size().maxCoeff(&axis);
        const std::size_t middle = first + (last - first) / 2;
        const auto begin = items.begin();
        // Of several in one place the first of the mesh comes first: the tree is always the same.
        std::nth_element(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(middle),
                         begin + std::ptrdiff_t(last), [axis](const Item& a, const Item& b) {
                             return std::pair{a.middle[axis], a.triangle}
                                    < std::pair{b.middle[axis], b.triangle};
                         });
        node.left = build(items, first, middle);
        node.right = build(items, middle, last);
    }
    m_nodes.push_back(node);
    return m_nodes.size() - 1;
}

double SurfaceTree::distanceTo(const Vec3& p) const { return std::sqrt(nearest(p).squared); }

std::optional<SurfacePoint> SurfaceTree::nearestTo(const Vec3& p) const
{
    if (m_nodes.empty())
        return std::nullopt;
    const Corners& t = m_corners[nearest(p).triangle];
    return SurfacePoint{nearestPoint(t, p), (t.b - t.a).cross(t.c - t.a).normalized()};
}

SurfaceTree::Nearest SurfaceTree::nearest(const Vec3& p) const
{
    Nearest found;
    if (!m_nodes.empty())
        search(m_nodes.size() - 1, p, found);
    return found;
}

void SurfaceTree::search(std::size_t index, const Vec3& p, Nearest& found) const
{
    const Node& node = m_nodes[index];
    if (squaredTo(node.box, p) >= found.squared)
        return;
    if (node.last - node.first <= kLeaf) {
        for (std::size_t i = node.first; i < node.last; ++i)
            if (const double squared = squaredDistance(m_corners[i], p); squared < found.squared)
                found = {squared, i};
        return;
    }
    const bool leftFirst =
        squaredTo(m_nodes[node.left].box, p) <= squaredTo(m_nodes[node.right].box, p);
    search(leftFirst ? node.left : node.right, p, found);
    search(leftFirst ? node.right : node.left, p, found);
}

std::size_t SurfaceTree::selfIntersections() const
{
    return m_nodes.empty() ? 0 : intersections(m_nodes.size() - 1, m_nodes.size() - 1);
}

/// Pairs with one triangle in each node; of a node with itself each pair once.
std::size_t SurfaceTree::intersections(std::size_t a, std::size_t b) const
{
    const Node& na = m_nodes[a];
    const Node& nb = m_nodes[b];
    if (!overlap(na.box, nb.box))
        return 0;
    const bool leafA = na.last - na.first <= kLeaf;
    const bool leafB = nb.last - nb.first <= kLeaf;
    if (leafA && leafB) {
        std::size_t pairs = 0;
        for (std::size_t i = na.first; i < na.last; ++i)
            for (std::size_t j = a == b ? i + 1 : nb.first; j < nb.last; ++j)
                pairs += intersect(i, j) ? 1 : 0;
        return pairs;
    }
    if (a == b)
        return intersections(na.left, na.left) + intersections(na.right, na.right)
               + intersections(na.left, na.right);
    const bool splitA = leafB || (!leafA && na.last - na.first > nb.last - nb.first);
    return splitA ? intersections(na.left, b) + intersections(na.right, b)
                  : intersections(a, nb.left) + intersections(a, nb.right);
}

bool SurfaceTree::intersect(std::size_t i, std::size_t j) const
{
    if (!overlap(boxOf(m_corners[i]), boxOf(m_corners[j])))
        return false;
    const auto holds = [](const Triangle& t, std::uint32_t v) {
        return std::ranges::find(t, v) != t.end();
    };
    const auto common = std::ranges::count_if(
        m_triangles[i], [&](std::uint32_t v) { return holds(m_triangles[j], v); });
    if (common > 1)
        return false;
    const auto pierces = [&](std::size_t from, std::size_t through) {
        const std::array<Vec3, 3> corners = arrayOf(m_corners[from]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (!holds(m_triangles[through], m_triangles[from][k])
                && !holds(m_triangles[through], m_triangles[from][next])
                && runsThrough(m_corners[through], corners[k], corners[next]))
                return true;
        }
        return false;
    };
    return pierces(i, j) || pierces(j, i);
}

} // namespace carina
