#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// Sorts triangles for blending: the farthest from an eye first.
///
/// Blending in that order gives correct translucency in each pixel whose triangles are farther
/// apart in depth than they are long (the painter's algorithm; Newell, Newell and Sancha 1972).
/// Depth is measured along the line of sight, in steps of kStep: triangles within one step keep
/// their given order, so that neighbours, which share corners, mostly stay neighbours.
class DrawOrder
{
public:
    static constexpr float kStep = 1e-3F; ///< metres

    DrawOrder() = default;
    /// @param positions of the vertices that the triangles index, metres
    DrawOrder(std::vector<Triangle> triangles, std::span<const Vec3f> positions);

    /// All triangles, farthest along `forward` (of length 1) first.
    [[nodiscard]] std::vector<Triangle> backToFront(const Vec3f& forward) const;

    [[nodiscard]] bool empty() const { return m_triangles.empty(); }

private:
    std::vector<Triangle> m_triangles;
    std::vector<Vec3f> m_centres;
};

} // namespace carina
