#pragma once

#include "engine/core/result.h"
#include "engine/lungs/mechanics/lung_pair.h"
#include "widgets/scene/surfaces/drawn_vertices.h"

#include <array>
#include <vector>

namespace carina::lab
{

/// Both lungs in one level of detail on the graphics card, to ask what volume is really drawn.
/// @pre there is a QGuiApplication; the lungs outlive this.
class DrawnLungs
{
public:
    /// @returns NoGraphics as DrawnVertices does.
    /// @pre level < lungs.levelCount().
    [[nodiscard]] static Result<DrawnLungs> of(const LungPair& lungs, std::size_t level);

    /// What the vertices enclose that the shader draws in a pose, right and left: the tetrahedra
    /// that each triangle spans with its surface's first vertex, summed in double.
    [[nodiscard]] Result<std::array<Volume, 2>> volumes(const ChestPose& pose);

private:
    /// One closed part, and the triangles between its vertices.
    struct Part {
        Side side = Side::Right;
        ChestRegion region = ChestRegion::Still;
        const std::vector<Triangle>* triangles = nullptr;
        DrawnVertices vertices;
    };

    explicit DrawnLungs(const ChestField& field) : m_field{field} {}

    ChestField m_field;
    std::vector<Part> m_parts;
};

} // namespace carina::lab
