#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <algorithm>

namespace carina
{

/// One use of an edge by a triangle, which runs from the lower to the higher of its two vertices
/// (`forward`) or back.
struct EdgeUse {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
    bool forward;

    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// All uses, three for each triangle, those of one edge beside each other.
[[nodiscard]] std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh);

using EdgeUseIterator = std::vector<EdgeUse>::const_iterator;

/// Calls visit(first, last) with the uses of each edge in turn.
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

/// How many more of the uses of one edge run forward than back; 0 where a surface is closed.
[[nodiscard]] long excessForward(EdgeUseIterator first, EdgeUseIterator last);

} // namespace carina
