#include "evaluation/intubation/way_walls.h"

#include "engine/anatomy/airway/centreline.h"
#include "engine/geometry/mesh/surface_tree.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kLeastAcross = 1e-3; ///< of a direction, to x

/// What a tube meets; bones and cartilages lie behind it.
bool isMetByTube(PartRole role)
{
    constexpr std::array kMet{PartRole::Mucosa,          PartRole::Tongue,  PartRole::Pharynx,
                              PartRole::LaryngealMucosa, PartRole::Larynx,  PartRole::Epiglottis,
                              PartRole::VocalFold,       PartRole::Trachea, PartRole::Tooth,
                              PartRole::Mandible};
    return std::ranges::find(kMet, role) != kMet.end();
}

/// The triangles that have a corner within `most` of a line.
TriangleMesh surfacesNear(const Anatomy& anatomy, std::span<const Vec3> line, double most)
{
    TriangleMesh near;
    for (const AnatomyPart& part : anatomy.parts) {
        if (!isMetByTube(part.role))
            continue;
        const TriangleMesh& whole = part.levels.front();
        std::vector<bool> isNear;
        for (const Vec3f& p : whole.positions)
            isNear.push_back(std::ranges::any_of(line, [&](const Vec3& on) {
                return (p.cast<double>() - on).squaredNorm() < most * most;
            }));
        TriangleMesh kept;
        kept.positions = whole.positions;
        for (const Triangle& t : whole.triangles)
            if (isNear[t[0]] || isNear[t[1]] || isNear[t[2]])
                kept.triangles.push_back(t);
        if (!kept.triangles.empty())
            append(near, kept);
    }
    return near;
}

bool isInside(const SurfaceTree& surfaces, const Vec3& p_A)
{
    const auto nearest = surfaces.nearestTo(p_A);
    return nearest && (p_A - nearest->p).dot(nearest->normal) < 0.0;
}

/// How far it is to the first surface in a unit direction: by steps as long as the nearest surface
/// is far away.
double freeWay(const SurfaceTree& surfaces, const Vec3& p_A, const Vec3& direction, double most)
{
    constexpr int kMostTouches = 40;
    constexpr double kTouching = 2e-4; // metres
    double way = 0.0;
    for (int i = 0; i < kMostTouches && way < most; ++i) {
        const double step = surfaces.distanceTo(p_A + way * direction);
        if (step < kTouching)
            return way;
        way += step;
    }
    return std::min(way, most);
}

/// @param wayTo how far the wall is from a place in a direction
template <class WayTo>
WallsAround wallsAround(std::span<const Vec3> line, double along, const WayTo& wayTo)
{
    const Vec3 p_A = pointAlong(line, metres(along));
    const Vec3 before = pointAlong(line, metres(along) - kWallsEach);
    const Vec3 behind = pointAlong(line, metres(along) + kWallsEach);
    const Mat3 axes = acrossAxesOf(behind - before).value_or(Mat3::Identity());
    WallsAround walls{.along = along, .p_A_walls = {}};
    for (const WallSide side : kWallSides) {
        const auto s = static_cast<Eigen::Index>(side);
        const Vec3 direction = (s % 2 == 0 ? 1.0 : -1.0) * axes.col(s / 2);
        walls.p_A_walls[static_cast<std::size_t>(side)] = p_A + wayTo(p_A, direction) * direction;
    }
    return walls;
}

} // namespace

std::optional<Mat3> acrossAxesOf(const Vec3& direction)
{
    const Vec3 along = direction.stableNormalized();
    const Vec3 across = Vec3::UnitX() - along.x() * along;
    if (!(along.norm() > 0.5) || across.norm() < kLeastAcross)
        return std::nullopt;
    Mat3 axes;
    axes << across.normalized(), along.cross(across.normalized()), along;
    return axes;
}

std::vector<WallsAround> wallsAlong(const Anatomy& anatomy, std::span<const Vec3> line, Length from,
                                    Length until, Length most)
{
    const SurfaceTree surfaces{
        surfacesNear(anatomy, evenlySpaced(line, kWallsEach), 1.5 * most.si)};
    const auto wayTo = [&](const Vec3& p_A, const Vec3& direction) {
        return freeWay(surfaces, p_A, direction, most.si);
    };
    std::vector<WallsAround> walls;
    for (double along = from.si; along <= until.si; along += kWallsEach.si)
        if (!isInside(surfaces, pointAlong(line, metres(along))))
            walls.push_back(wallsAround(line, along, wayTo));
    return walls;
}

std::vector<WallsAround> roundWalls(std::span<const Vec3> line, Length from, Length until,
                                    Length radius)
{
    std::vector<WallsAround> walls;
    const auto wayTo = [&](const Vec3& /*p_A*/, const Vec3& /*direction*/) { return radius.si; };
    for (double along = from.si; along <= until.si; along += kWallsEach.si)
        walls.push_back(wallsAround(line, along, wayTo));
    return walls;
}

} // namespace carina
