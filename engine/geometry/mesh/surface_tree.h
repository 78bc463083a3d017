#pragma once

#include "engine/geometry/mesh/triangle_query.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace carina
{

/// A point of a surface, and the unit normal of the triangle it lies on: of zero length where that
/// has no area.
struct SurfacePoint {
    Vec3 p;
    Vec3 normal;
};

/// A surface sorted into nested boxes, for many questions about it. Holds a copy of the corners, so
/// that the mesh may go.
class SurfaceTree
{
public:
    explicit SurfaceTree(const TriangleMesh& mesh);

    /// Distance of a point from the nearest point of the surface, metres; infinity where it is
    /// empty. The same number as distanceTo(mesh, p), sooner.
    [[nodiscard]] double distanceTo(const Vec3& p) const;

    /// The nearest point of the surface; nothing where it is empty.
    [[nodiscard]] std::optional<SurfacePoint> nearestTo(const Vec3& p) const;

    /// Pairs of triangles of which an edge of one runs through the inside of the other. Triangles
    /// with an edge in common are no pair, and with a corner in common only the edge across from it
    /// counts, so that a surface whose vertices are welded has none unless it meets itself.
    [[nodiscard]] std::size_t selfIntersections() const;

private:
    struct Node {
        Box box;
        std::size_t first = 0; ///< of its triangles
        std::size_t last = 0;  ///< behind them
        std::size_t left = 0;  ///< its two halves; both 0 in a leaf
        std::size_t right = 0;
    };

    /// A triangle while the tree is built.
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
    std::vector<Corners> m_corners;    ///< of the same
    std::vector<Node> m_nodes;         ///< the whole surface is the last
};

} // namespace carina
