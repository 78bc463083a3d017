#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// Puts triangles into the order in which they are blended: the farthest from an eye first.
///
/// Blended one over the other in that order, translucent surfaces come out as seen by light that
/// passes through all of them, wherever no two triangles that cover a pixel lie closer to each
/// other than they are long (the painter's algorithm; Newell, Newell and Sancha 1972). Depth is
/// measured along the line of sight, in steps of kStep: what lies within one step keeps the order
/// it was given in, so that neighbours, which share corners, mostly stay neighbours.
class DrawOrder
{
public:
    static constexpr float kStep = 1e-3F; ///< metres

    DrawOrder() = default;
    /// @param positions of the vertices that the corners of triangles count, metres
    DrawOrder(std::vector<Triangle> triangles, std::span<const Vec3f> positions);

    /// All triangles, farthest along `forward` (of length 1) first.
    [[nodiscard]] std::vector<Triangle> backToFront(const Vec3f& forward) const;

    [[nodiscard]] bool empty() const { return m_triangles.empty(); }

private:
    std::vector<Triangle> m_triangles;
    std::vector<Vec3f> m_centres;
};

} // namespace carina
