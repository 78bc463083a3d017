#pragma once

#include "engine/geometry/deformation/chest_field.h"

#include <array>
#include <vector>

namespace carina
{

/// Vertices as columns of numbers, which processors move many at a time.
struct VertexColumns {
    std::array<std::vector<float>, 3> position; ///< x, y and z in A, metres; all of one length
    std::array<std::vector<float>, 3> normal;   ///< likewise, of unit length

    [[nodiscard]] std::size_t size() const { return position[0].size(); }
};

[[nodiscard]] VertexColumns columnsOf(const TriangleMesh& mesh);

/// What deformed() does, for many vertices and on all processors: the same numbers but
/// for rounding. `moved` gets the length of `rest`; where it has it already, nothing is allocated.
/// @pre both columns of `rest` are of one length.
void deformColumns(const VertexColumns& rest, const ChestField& field, const ChestMotion& motion,
                   VertexColumns& moved);

} // namespace carina
