#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <algorithm>

namespace carina
{

/// One use of an edge by a triangle. It is `forward` where the triangle's winding runs from the
/// edge's vertex of lower index to that of higher index.
struct EdgeUse {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
    bool forward;

    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// All edge uses of a mesh, three per triangle, sorted so that those of one edge are adjacent.
[[nodiscard]] std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh);

using EdgeUseIterator = std::vector<EdgeUse>::const_iterator;

/// Calls visit(first, last) once per edge, with the range of its uses.
/// @pre the uses are sorted (sortedEdgeUses).
template <class Visit> void forEachEdge(const std::vector<EdgeUse>& uses, const Visit& visit)
{
    for (auto first = uses.begin(); first != uses.end();) {
        auto last = first;
        while (last != uses.end() && last->low == first->low && last->high == first->high)
            ++last;
        visit(first, last);
        first = last;
    }
}

/// The uses of one edge that run forward minus those that run back; 0 where a surface is closed.
[[nodiscard]] long excessForward(EdgeUseIterator first, EdgeUseIterator last);

} // namespace carina
