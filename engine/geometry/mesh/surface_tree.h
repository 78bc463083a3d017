#pragma once

#include "engine/geometry/mesh/triangle_query.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace carina
{

/// A point of a surface, and the unit normal of its triangle; a zero vector where the triangle is
/// degenerate.
struct SurfacePoint {
    Vec3 p;
    Vec3 normal;
};

/// A bounding volume hierarchy of a surface's triangles, for many queries. It stores a copy of the
/// triangles: the mesh need not outlive it.
class SurfaceTree
{
public:
    explicit SurfaceTree(const TriangleMesh& mesh);

    /// Distance of a point from the nearest point of the surface, metres; infinity where the
    /// surface is empty. The same result as distanceTo(mesh, p), but faster.
    [[nodiscard]] double distanceTo(const Vec3& p) const;

    /// The nearest point of the surface; nothing where the surface is empty.
    [[nodiscard]] std::optional<SurfacePoint> nearestTo(const Vec3& p) const;

    /// The number of pairs of triangles of which an edge of one passes through the interior of the
    /// other. Triangles that share an edge are not counted; of triangles that share a vertex only
    /// the edges opposite to it are tested. So a welded surface has 0 unless it intersects itself.
    [[nodiscard]] std::size_t selfIntersections() const;

private:
    struct Node {
        Box box;
        std::size_t first = 0; ///< its first triangle
        std::size_t last = 0;  ///< behind its last triangle
        std::size_t left = 0;  ///< its child nodes; both 0 in a leaf
        std::size_t right = 0;
    };

    /// A triangle during construction of the tree.
    struct Item {
        Box box;
        Vec3 middle;
        std::uint32_t triangle;
    };

    struct Nearest {
        double squared = std::numeric_limits<double>::infinity();
        std::size_t triangle = 0;
    };

    std::size_t build(std::vector<Item>& items, std::size_t first, std::size_t last);
    [[nodiscard]] Nearest nearest(const Vec3& p) const;
    void search(std::size_t node, const Vec3& p, Nearest& found) const;
    [[nodiscard]] std::size_t intersections(std::size_t a, std::size_t b) const;
    [[nodiscard]] bool intersect(std::size_t i, std::size_t j) const;

    std::vector<Triangle> m_triangles; ///< in the order of the leaves
    std::vector<Corners> m_corners;    ///< of the same triangles
    std::vector<Node> m_nodes;         ///< the root is the last
};

} // namespace carina
