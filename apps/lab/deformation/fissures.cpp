#include "apps/lab/deformation/fissures.h"

#include "engine/geometry/mesh/surface_query.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

/// How much longer the way along the normal may be than the shortest one: at the rim of a fissure
/// the normal turns away from it.
constexpr double kAskew = 1.2;
constexpr double kFlat_m = 5e-5; ///< where both are next to nothing

bool isLower(const BreathingPart& part)
{
    return part.region == ChestRegion::RightLowerLung || part.region == ChestRegion::LeftLowerLung;
}

Vec3 at(const std::vector<Vec3f>& vectors, std::size_t i) { return vectors[i].cast<double>(); }

/// Whether a surface that lies near a place with this normal lies behind it: they overlap.
bool isBehind(const TriangleMesh& surface, const Vec3& p_A, const Vec3& normal)
{
    const auto ahead = rayHit(surface, p_A, normal);
    const auto behind = rayHit(surface, p_A, -normal);
    return behind && (!ahead || *behind < *ahead);
}

/// Whether a vertex of the lower lobe lies at the fissure: the upper one is near, and its normal
/// points there.
bool isAtFissure(const TriangleMesh& surface, const Vec3& p_A, const Vec3& normal)
{
    const double distance = distanceTo(surface, p_A);
    if (distance > kFissure.si)
        return false;
    const double reach = kAskew * distance + kFlat_m;
    return rayHit(surface, p_A, normal).value_or(1.0) <= reach
           || rayHit(surface, p_A, -normal).value_or(1.0) <= reach;
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
        const Vec3 normal = at(lower.rest.normals, i);
        if (distanceTo(near, p_A) > kFissure.si || !isAtFissure(upper.rest, p_A, normal))
            continue;
        const double slide =
            (field.at(p_A, lower.motion).d_A - field.at(p_A, upper.motion).d_A).norm();
        const Vec3 moved_A = at(lower.moved.positions, i);
        const bool overlapped = isBehind(upper.rest, p_A, normal);
        const double before = distanceTo(upper.rest, p_A);
        const double after = distanceTo(upper.moved, moved_A);
        // A distance changes by no more than what moves: a side far from 0 is not left.
        const bool overlaps = before + after > slide
                                  ? overlapped
                                  : isBehind(upper.moved, moved_A, at(lower.moved.normals, i));
        const double change_mm =
            1e3 * ((overlaps ? -after : after) - (overlapped ? -before : before));
        ++fit.points;
        fit.gap_mm = std::max(fit.gap_mm, change_mm);
        fit.overlap_mm = std::max(fit.overlap_mm, -change_mm);
        fit.meanSlide_mm += 1e3 * slide;
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
