#pragma once

#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace carina
{

/// The surfaces of tissue that can shade each other, in cells of a grid: how much of what a place
/// faces is hidden by tissue close by. Hollows, and what lies between folds, get less of the light
/// that tissue scatters (ambient occlusion, by discs: M. Bunnell, GPU Gems 2, chapter 14, 2005).
class NearTissue
{
public:
    static constexpr Length kReach = millimetres(9.0); ///< beyond which nothing hides; of ours
    static constexpr Length kCell = millimetres(3.0);
    /// Along each axis; of what is longer nothing is hidden. Of ours.
    static constexpr Length kMost = millimetres(600.0);

    /// @param meshes in one frame, metres; none of them has to be kept
    explicit NearTissue(std::span<const TriangleMesh* const> meshes);

    /// From 0, nothing hidden, up to 1.
    /// @param normal of length 1, to the side that is seen
    [[nodiscard]] float hiddenAt(const Vec3f& p, const Vec3f& normal) const;

private:
    /// A disc in place of the triangles whose centres are in one cell.
    struct Disc {
        Vec3f centre = Vec3f::Zero();
        float area = 0.0F; ///< square metres
    };
    using Cell = Eigen::Vector3i;

    [[nodiscard]] Cell cellOf(const Vec3f& p) const;
    [[nodiscard]] std::size_t placeOf(const Cell& cell) const;
    void add(const TriangleMesh& mesh);

    Vec3f m_corner = Vec3f::Zero(); ///< the least of all
    Cell m_cells = Cell::Zero();    ///< along each axis; 0 without tissue
    std::vector<Disc> m_discs;
};

} // namespace carina
