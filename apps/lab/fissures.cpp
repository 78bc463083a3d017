#include "apps/lab/fissures.h"

#include "engine/geometry/surface_query.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace carina::lab
{
namespace
{

/// Beyond this the other lobe is no longer beside a vertex: it has left the fissure's rim.
constexpr double kLost_m = 6e-3;

bool isLower(const BreathingPart& part)
{
    return part.region == ChestRegion::RightLowerLung || part.region == ChestRegion::LeftLowerLung;
}

Vec3 at(const std::vector<Vec3f>& vectors, std::size_t i) { return vectors[i].cast<double>(); }

/// Distance from a place to a surface along the normal there; negative where it lies inside.
std::optional<double> distanceAlong(const Vec3& normal, const Vec3& p_A,
                                    const TriangleMesh& surface)
{
    const double ahead = rayHit(surface, p_A, normal).value_or(kLost_m);
    const double behind = rayHit(surface, p_A, -normal).value_or(kLost_m);
    if (std::min(ahead, behind) >= kLost_m)
        return std::nullopt;
    return ahead <= behind ? ahead : -behind;
}

struct MovingLobe {
    const TriangleMesh& rest;
    TriangleMesh moved;
    ChestMotion motion;
};

MovingLobe moving(const BreathingPart& part, const LungPair& lungs, const ChestPose& pose)
{
    const ChestMotion motion = motionOf(part.region, pose, lungs.field());
    return {part.levels.front(), deformed(part.levels.front(), lungs.field(), motion), motion};
}

FissureFit fitOf(const MovingLobe& lower, const MovingLobe& upper, const ChestField& field)
{
    FissureFit fit;
    const Box near = boundsOf(upper.rest);
    for (std::size_t i = 0; i < lower.rest.positions.size(); ++i) {
        const Vec3 p_A = at(lower.rest.positions, i);
        if (distanceTo(near, p_A) > kFissure.si)
            continue;
        const auto before = distanceAlong(at(lower.rest.normals, i), p_A, upper.rest);
        if (!before || std::abs(*before) > kFissure.si)
            continue;
        const auto after =
            distanceAlong(at(lower.moved.normals, i), at(lower.moved.positions, i), upper.moved);
        if (!after)
            continue;
        ++fit.points;
        fit.gap_mm = std::max(fit.gap_mm, 1e3 * (*after - *before));
        fit.overlap_mm = std::max(fit.overlap_mm, 1e3 * (*before - *after));
        fit.meanSlide_mm +=
            1e3 * (field.at(p_A, lower.motion).d_A - field.at(p_A, upper.motion).d_A).norm();
    }
    if (fit.points > 0)
        fit.meanSlide_mm /= double(fit.points);
    return fit;
}

} // namespace

std::vector<FissureFit> fissuresOf(const Anatomy& anatomy, const LungPair& lungs,
                                   const ChestPose& pose)
{
    std::vector<FissureFit> fits;
    for (const BreathingPart& lower : lungs.parts()) {
        if (!isLower(lower))
            continue;
        const MovingLobe moved = moving(lower, lungs, pose);
        for (const BreathingPart& upper : lungs.parts()) {
            if (upper.side != lower.side || isLower(upper))
                continue;
            FissureFit fit = fitOf(moved, moving(upper, lungs, pose), lungs.field());
            fit.upper = anatomy.parts[upper.index].name;
            fit.lower = anatomy.parts[lower.index].name;
            fits.push_back(std::move(fit));
        }
    }
    return fits;
}

} // namespace carina::lab
