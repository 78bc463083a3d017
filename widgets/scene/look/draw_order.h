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
/// Depth is measured along the line of sight, in steps as long as the mean edge is: triangles
/// within one step keep their given order, so that neighbours, which share corners, mostly stay
/// neighbours. Each corner is then computed about once and not for each of its triangles, which
/// matters most where that is done by the processor: with coarse surfaces and steps of 1 mm a frame
/// took half as long again.
class DrawOrder
{
public:
    static constexpr float kLeastStep = 1e-3F; ///< metres
    static constexpr float kMostStep = 8e-3F;

    DrawOrder() = default;
    /// @param positions of the vertices that the triangles index, metres
    DrawOrder(std::vector<Triangle> triangles, std::span<const Vec3f> positions);

    /// All triangles, farthest along `forward` (of length 1) first.
    [[nodiscard]] std::vector<Triangle> backToFront(const Vec3f& forward) const;

    /// Metres.
    [[nodiscard]] float step() const { return m_step; }
    [[nodiscard]] bool empty() const { return m_triangles.empty(); }

private:
    std::vector<Triangle> m_triangles;
    std::vector<Vec3f> m_centres;
    float m_step = kLeastStep;
};

} // namespace carina
