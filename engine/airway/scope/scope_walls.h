#pragma once

#include "engine/airway/lumen/moved_lumen.h"
#include "engine/anatomy/anatomy.h"
#include "engine/geometry/mesh/triangle_query.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// The surfaces that stop a camera in an airway, where the tissue is at a moment. A, metres.
///
/// Triangles are kept in patches of at most kPatch neighbours. At each moment the middles of all
/// patches are moved; corners are moved only of those patches that can be near the camera, where
/// one may have become kMostStretch times as large as it is in the surfaces (of ours).
class ScopeWalls
{
public:
    /// @param parts whose finest triangles stop it; the first level of each is read
    /// @param line near which it flies; triangles farther than `reach` from all its points are
    ///             left out
    ScopeWalls(std::span<const AnatomyPart> parts, std::span<const Vec3> line, Length reach);

    [[nodiscard]] bool isEmpty() const { return m_patches.empty(); }

    /// The tissue is moved so from now on. @pre what the motion reads outlives this, or lives until
    /// the next move()
    void move(const TissueMotion& motion);
    /// How the tissue around a place of the moment before has moved since: the rigid motion that
    /// fits the middles of patches there best. The identity at the first moment.
    [[nodiscard]] RigidTransform carriedFrom(const Vec3& p_A) const;

    /// Whether the middle of a patch is so near a place.
    [[nodiscard]] bool isWithin(const Vec3& p_A, Length reach) const;

    /// Distance from a place to the nearest surface of the moment, and the place of that; kSeen
    /// where there is none so near.
    struct Nearest {
        Vec3 p_A = Vec3::Zero();
        double distance = kSeen;
    };
    [[nodiscard]] Nearest nearestTo(const Vec3& p_A);

    static constexpr double kSeen = 0.006; ///< metres
    static constexpr std::size_t kPatch = 32;
    static constexpr double kMostStretch = 2.0;

private:
    struct Wall {
        std::vector<Vec3> corners; ///< as in the surfaces
        AirwayTissue tissue;
    };
    struct Patch {
        std::size_t wall = 0;
        std::vector<Triangle> triangles; ///< of the wall's corners
        Vec3 middle = Vec3::Zero();      ///< as in the surfaces, as those that follow
        double radius = 0.0;
        Vec3 before = Vec3::Zero(); ///< at the moment before
        Vec3 now = Vec3::Zero();
    };
    /// The triangles of a patch as they are now.
    struct NearPatch {
        Box box;
        std::vector<Corners> triangles;
    };

    /// A triangle during division.
    struct Placed {
        Vec3 middle;
        Triangle triangle;
    };

    void addWall(const TriangleMesh& mesh, AirwayTissue tissue);
    void divide(std::size_t wall, std::span<Placed> triangles);
    void comeNear(const Vec3& p_A);

    std::vector<Wall> m_walls;
    std::vector<Patch> m_patches;
    TissueMotion m_motion;
    bool m_hasMoved = false;
    std::vector<NearPatch> m_near; ///< all that is within kGathered of m_about
    std::optional<Vec3> m_about;
};

} // namespace carina
