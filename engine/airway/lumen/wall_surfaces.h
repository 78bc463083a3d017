#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/units.h"
#include "engine/geometry/deformation/airway_tissue.h"
#include "engine/geometry/mesh/surface_tree.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// Whether a part lines an airway; bones, cartilages and muscles lie behind that, but they alone
/// are there in sets without mucosa.
[[nodiscard]] bool isAirwayWall(PartRole role);
/// As which tissue a part moves where it is a wall: what is fixed to the lower jaw as the throat.
[[nodiscard]] AirwayTissue tissueOfWall(const AnatomyPart& part);
/// The triangles with a corner that is less than `reach` from a point of the line.
[[nodiscard]] TriangleMesh trianglesNear(const TriangleMesh& mesh, std::span<const Vec3> line,
                                         Length reach);

/// The surfaces that a tube meets in an airway, near a line; in A.
class WallSurfaces
{
public:
    /// @param reach triangles farther from every point of the line than this are left out
    WallSurfaces(std::span<const AnatomyPart> parts, std::span<const Vec3> line, Length reach);

    [[nodiscard]] bool isEmpty() const { return m_walls.empty(); }

    struct Place {
        Vec3 p_A = Vec3::Zero();
        AirwayTissue tissue = AirwayTissue::Pharynx;
        double distance = 0.0; ///< metres; below 0 inside of a surface
    };
    /// The nearest place; nothing where there is no surface.
    [[nodiscard]] std::optional<Place> nearestTo(const Vec3& p_A) const;

    /// How far a ball goes from a place in a unit direction before it touches something, metres.
    [[nodiscard]] double wayOfBall(const Vec3& p_A, const Vec3& direction, double radius,
                                   double most) const;

private:
    struct Wall {
        SurfaceTree tree;
        AirwayTissue tissue;
    };
    [[nodiscard]] double distanceTo(const Vec3& p_A) const;

    std::vector<Wall> m_walls; ///< one of each tissue
};

} // namespace carina
