#include "engine/airway/lumen/wall_surfaces.h"

#include "engine/anatomy/chest/chest_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace carina
{
bool isAirwayWall(PartRole role)
{
    constexpr std::array kWalls{PartRole::Trachea,
                                PartRole::RightMainBronchus,
                                PartRole::LeftMainBronchus,
                                PartRole::Larynx,
                                PartRole::LaryngealMucosa,
                                PartRole::VocalFold,
                                PartRole::Tongue,
                                PartRole::Epiglottis,
                                PartRole::Tooth,
                                PartRole::Mandible,
                                PartRole::Mucosa,
                                PartRole::Pharynx};
    return std::ranges::find(kWalls, role) != kWalls.end();
}

AirwayTissue tissueOfWall(const AnatomyPart& part)
{
    if (part.role == PartRole::Mandible || movesWithMandible(part))
        return AirwayTissue::Throat;
    const ChestRegion region = regionOf(part);
    return region == ChestRegion::Bronchi ? AirwayTissue::Windpipe
                                          : airwayTissueOf(region).value_or(AirwayTissue::Pharynx);
}

TriangleMesh trianglesNear(const TriangleMesh& mesh, std::span<const Vec3> line, Length reach)
{
    const double squared = reach.si * reach.si;
    Box around;
    for (const Vec3& on : line)
        around.include(on);
    std::vector<bool> isNear(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p = mesh.positions[i].cast<double>();
        isNear[i] = (p - p.cwiseMax(around.min).cwiseMin(around.max)).squaredNorm() < squared
                    && std::ranges::any_of(
                        line, [&](const Vec3& on) { return (p - on).squaredNorm() < squared; });
    }
    TriangleMesh part;
    part.positions = mesh.positions;
    for (const Triangle& t : mesh.triangles)
        if (isNear[t[0]] || isNear[t[1]] || isNear[t[2]])
            part.triangles.push_back(t);
    return part;
}

WallSurfaces::WallSurfaces(std::span<const AnatomyPart> parts, std::span<const Vec3> line,
                           Length reach)
{
    constexpr std::array kTissues{AirwayTissue::LooseTooth, AirwayTissue::Teeth,
                                  AirwayTissue::Skin,       AirwayTissue::Windpipe,
                                  AirwayTissue::Throat,     AirwayTissue::Pharynx,
                                  AirwayTissue::Larynx};
    for (const AirwayTissue tissue : kTissues) {
        TriangleMesh whole;
        for (const AnatomyPart& part : parts)
            if (isAirwayWall(part.role) && tissueOfWall(part) == tissue)
                append(whole, trianglesNear(part.levels.front(), line, reach));
        if (!whole.empty())
            m_walls.push_back({SurfaceTree{whole}, tissue});
    }
}

double WallSurfaces::distanceTo(const Vec3& p_A) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : m_walls)
        nearest = std::min(nearest, wall.tree.distanceTo(p_A));
    return nearest;
}

std::optional<WallSurfaces::Place> WallSurfaces::nearestTo(const Vec3& p_A) const
{
    std::optional<Place> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Wall& wall : m_walls) {
        const std::optional<SurfacePoint> there = wall.tree.nearestTo(p_A);
        if (!there || (there->p - p_A).norm() >= least)
            continue;
        least = (there->p - p_A).norm();
        const bool isInside = (p_A - there->p).dot(there->normal) < 0.0;
        nearest = {there->p, wall.tissue, isInside ? -least : least};
    }
    return nearest;
}

double WallSurfaces::wayOfBall(const Vec3& p_A, const Vec3& direction, double radius,
                               double most) const
{
    constexpr int kMostSteps = 60;
    constexpr double kTouching = 2e-5; // metres
    double way = 0.0;
    for (int i = 0; i < kMostSteps && way < most; ++i) {
        const double room = distanceTo(p_A + way * direction) - radius;
        if (room < kTouching)
            return way;
        way += room;
    }
    return std::min(way, most);
}

} // namespace carina
