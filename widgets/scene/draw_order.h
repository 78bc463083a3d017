#pragma once

#include "engine/geometry/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// Puts triangles into the order in which they are blended: the farthest along a direction first.
///
/// Blended one over the other in that order, translucent surfaces come out as seen by light that
/// passes through all of them, wherever no two triangles that cover a pixel lie closer to each
/// other than they are long (the painter's algorithm; Newell, Newell and Sancha 1972). For parallel
/// cameras, such as both eyes of a headset, the order is the same. It depends on the direction
/// alone, so zooming and shifting a camera leave it as it is.
class DrawOrder
{
public:
    DrawOrder() = default;
    /// @param positions of the vertices that the corners of triangles count
    DrawOrder(std::vector<Triangle> triangles, std::span<const Vec3f> positions);

    /// All triangles, those that lie farthest along `forward` first, to within one part in 65,535
    /// of the depth of the whole; those that lie equally far in the order they were given in.
    [[nodiscard]] std::vector<Triangle> backToFront(const Vec3f& forward) const;

    [[nodiscard]] bool empty() const { return m_triangles.empty(); }

private:
    std::vector<Triangle> m_triangles;
    std::vector<Vec3f> m_centres; ///< three times the mean of the corners
};

} // namespace carina
