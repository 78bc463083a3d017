#pragma once

#include "engine/geometry/deformation/chest_field.h"

#include <array>
#include <vector>

namespace carina
{

/// Vertices as one array for each coordinate, for vectorised (SIMD) computation.
struct VertexColumns {
    std::array<std::vector<float>, 3> position; ///< x, y and z in A, metres; all of one length
    std::array<std::vector<float>, 3> normal;   ///< likewise, of unit length

    [[nodiscard]] std::size_t size() const { return position[0].size(); }
};

/// @pre the mesh has one normal for each vertex.
[[nodiscard]] VertexColumns columnsOf(const TriangleMesh& mesh);

/// The same as deformed(), for many vertices on all processors; results differ by rounding only.
/// `moved` is resized to the length of `rest`; nothing is allocated where it has that length
/// already.
/// @pre all columns of `rest` are of one length.
void deformColumns(const VertexColumns& rest, const ChestField& field, const ChestMotion& motion,
                   VertexColumns& moved);

} // namespace carina
