#include "engine/airway/scope/scope_walls.h"

#include "engine/airway/lumen/wall_surfaces.h"
#include "engine/geometry/fit/rigid_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace carina
{
namespace
{

constexpr double kGathered = 0.012;  ///< metres, about a place: of ours
constexpr double kCarries = 0.02;    ///< metres: tissue within it carries the camera along
constexpr double kSame = 1e-7;       ///< metres: tissue that moves by less stays
constexpr std::size_t kCarriers = 8; ///< patches that carry at least

double squaredToBox(const Box& box, const Vec3& p)
{
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm();
}

} // namespace

ScopeWalls::ScopeWalls(std::span<const AnatomyPart> parts, std::span<const Vec3> line, Length reach)
{
    for (const AnatomyPart& part : parts)
        addWall(trianglesNear(part.levels.front(), line, reach), tissueOfWall(part));
}

void ScopeWalls::addWall(const TriangleMesh& mesh, AirwayTissue tissue)
{
    if (mesh.empty())
        return;
    Wall wall{.corners = {}, .tissue = tissue};
    wall.corners.reserve(mesh.positions.size());
    for (const Vec3f& p : mesh.positions)
        wall.corners.push_back(p.cast<double>());
    std::vector<Placed> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        triangles.push_back(
            {(wall.corners[t[0]] + wall.corners[t[1]] + wall.corners[t[2]]) / 3.0, t});
    m_walls.push_back(std::move(wall));
    divide(m_walls.size() - 1, triangles);
}

/// In halves along the longest side of the box around their middles. Of several in one place the
/// order is that of their corners: the patches are always the same.
void ScopeWalls::divide(std::size_t wall, std::span<Placed> triangles)
{
    Box box;
    for (const Placed& placed : triangles)
        box.include(placed.middle);
    if (triangles.size() > kPatch) {
        int axis = 0;
        box.size().maxCoeff(&axis);
        const std::size_t half = triangles.size() / 2;
        std::ranges::nth_element(triangles, triangles.begin() + std::ptrdiff_t(half), {},
                                 [axis](const Placed& placed) {
                                     return std::pair{placed.middle[axis], placed.triangle};
                                 });
        divide(wall, triangles.first(half));
        divide(wall, triangles.subspan(half));
        return;
    }
    Patch patch{.wall = wall, .triangles = {}};
    patch.middle = patch.before = patch.now = box.centre();
    for (const Placed& placed : triangles) {
        patch.triangles.push_back(placed.triangle);
        for (const std::uint32_t corner : placed.triangle)
            patch.radius =
                std::max(patch.radius, (m_walls[wall].corners[corner] - patch.middle).norm());
    }
    m_patches.push_back(std::move(patch));
}

void ScopeWalls::move(const TissueMotion& motion)
{
    m_motion = motion;
    m_about.reset();
    for (Patch& patch : m_patches) {
        const Vec3 now = m_motion(patch.middle, m_walls[patch.wall].tissue);
        patch.before = m_hasMoved ? patch.now : now;
        patch.now = now;
    }
    m_hasMoved = true;
}

RigidTransform ScopeWalls::carriedFrom(const Vec3& p_A) const
{
    std::vector<LandmarkPair> pairs;
    double farthest = 0.0;
    for (const Patch& patch : m_patches) {
        if ((patch.before - p_A).norm() > kCarries)
            continue;
        pairs.push_back({.p_AQ = patch.now, .p_MQ = patch.before});
        farthest = std::max(farthest, (patch.now - patch.before).norm());
    }
    if (farthest < kSame || pairs.size() < kCarriers)
        return {};
    const auto fit = fitRigid(pairs);
    return fit ? fit->X_AM : RigidTransform{};
}

bool ScopeWalls::isWithin(const Vec3& p_A, Length reach) const
{
    const double squared = reach.si * reach.si;
    return std::ranges::any_of(
        m_patches, [&](const Patch& patch) { return (patch.now - p_A).squaredNorm() < squared; });
}

void ScopeWalls::comeNear(const Vec3& p_A)
{
    m_near.clear();
    m_about = p_A;
    for (const Patch& patch : m_patches) {
        if ((patch.now - p_A).norm() > kGathered + kMostStretch * patch.radius)
            continue;
        const Wall& wall = m_walls[patch.wall];
        const auto moved = [&](std::uint32_t corner) {
            return m_motion ? m_motion(wall.corners[corner], wall.tissue) : wall.corners[corner];
        };
        NearPatch near;
        for (const Triangle& t : patch.triangles) {
            near.triangles.push_back({moved(t[0]), moved(t[1]), moved(t[2])});
            for (const Vec3& p :
                 {near.triangles.back().a, near.triangles.back().b, near.triangles.back().c})
                near.box.include(p);
        }
        if (squaredToBox(near.box, p_A) < kGathered * kGathered)
            m_near.push_back(std::move(near));
    }
}

ScopeWalls::Nearest ScopeWalls::nearestTo(const Vec3& p_A)
{
    if (!m_about || (p_A - *m_about).norm() > kGathered - kSeen)
        comeNear(p_A);
    Nearest nearest{.p_A = p_A, .distance = kSeen};
    double least = kSeen * kSeen;
    for (const NearPatch& near : m_near) {
        if (squaredToBox(near.box, p_A) >= least)
            continue;
        for (const Corners& triangle : near.triangles) {
            if (const double squared = squaredDistance(triangle, p_A); squared < least) {
                least = squared;
                nearest = {nearestPoint(triangle, p_A), std::sqrt(squared)};
            }
        }
    }
    return nearest;
}

} // namespace carina
