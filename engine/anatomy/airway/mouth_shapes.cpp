#include "engine/anatomy/airway/mouth_shapes.h"

#include "engine/anatomy/shapes/strand.h"

#include <cmath>

namespace carina
{

namespace
{

/// All shapes here are in reference millimetres (BodyPlan) from the edge of the upper incisors.

constexpr Length kMouthVoxel = millimetres(1.6);

/// At rest it fills the mouth; a laryngoscope's blade holds it on the floor behind the lower teeth.
double tongue(const Vec3& p, Posture posture)
{
    const bool rest = posture == Posture::Rest;
    const double body = rest ? ellipsoidDistance(p - Vec3{0.0, 36.0, -1.0}, {18.5, 28.5, 15.5})
                             : ellipsoidDistance(p - Vec3{0.0, 40.0, -20.5}, {18.0, 16.0, 16.0});
    const double root = rest ? ellipsoidDistance(p - Vec3{0.0, 57.0, -8.5}, {16.5, 14.5, 13.5})
                             : ellipsoidDistance(p - Vec3{0.0, 45.0, -29.0}, {16.5, 12.0, 15.0});
    return roundedMin(body, root, 8.0);
}

/// Below the vault of the palate and between the teeth: negative there.
double belowVault(const Vec3& p)
{
    // The vault is an ellipsoid with its rim at the necks of the teeth; below it goes straight
    // down.
    const Vec3 q{p.x(), p.y() - 40.0, std::max(p.z() - 6.0, 0.0)};
    return ellipsoidDistance(q, {18.5, 35.5, 13.0});
}

double hardPalate(const Vec3& p)
{
    const double shell = std::abs(belowVault(p) - 2.2) - 1.8;
    return roundedMax(shell, std::max(7.0 - p.z(), p.y() - 47.0), 2.0);
}

Strand softPalate()
{
    std::vector<StrandPoint> points;
    const std::array<Vec3, 5> line{Vec3{0, 45, 20}, Vec3{0, 57, 22}, Vec3{0, 68, 21},
                                   Vec3{0, 76, 16}, Vec3{0, 79, 9}};
    const std::array<double, 5> wide{15.0, 15.0, 13.0, 6.5, 3.2};
    const std::array<double, 5> thin{2.4, 2.8, 3.0, 2.8, 2.4};
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 along = line[std::min<std::size_t>(i + 1, 4)] - line[i > 0 ? i - 1 : 0];
        points.push_back({line[i], wide[i], thin[i], along.cross(Vec3::UnitX()).normalized()});
    }
    return Strand{std::move(points)};
}

/// Free space keeps so far from what bounds it, so that no two surfaces lie in one place.
constexpr double kFree = 0.8;

double oralCavity(const Strand& soft, Posture posture, const Vec3& p)
{
    const double floor = posture == Posture::Rest ? -12.0 : -28.0;
    const double arch = belowVault(p) + kFree;
    const double walls = roundedMax(std::max(3.0 - p.y(), p.y() - 72.0), floor - p.z(), 4.0);
    const double outsideTongue = kFree - tongue(p, posture);
    const double outsidePalate = kFree - soft.distance(p);
    return roundedMax(roundedMax(arch, walls, 4.0), std::max(outsideTongue, outsidePalate), 2.0);
}

/// Converts a shape in reference millimetres, within a box, to A.
PartPlan planOf(const char* name, PartRole role, const char* concept_, const BodyPlan& plan,
                const Box& bounds_mm, Implicit local)
{
    const Vec3 origin = plan.inFace(Vec3::Zero());
    const double unit = plan.face;
    const Box bounds{plan.inFace(bounds_mm.min), plan.inFace(bounds_mm.max)};
    return {name,
            role,
            concept_,
            {bounds, [origin, unit, local = std::move(local)](
                         const Vec3& p_A) { return unit * local((p_A - origin) / unit); }},
            1e3 * unit * kMouthVoxel};
}

} // namespace

std::vector<PartPlan> mouth(const BodyPlan& plan)
{
    const Strand soft = softPalate();
    std::vector<PartPlan> parts;
    parts.push_back(planOf("Tongue", PartRole::Tongue, "FMA54640", plan,
                           {Vec3{-21, 5, -48}, Vec3{21, 75, 18}},
                           [posture = plan.posture](const Vec3& p) { return tongue(p, posture); }));
    parts.push_back(planOf("Hard palate", PartRole::Pharynx, "FMA55023", plan,
                           {Vec3{-26, -2, 5}, Vec3{26, 52, 26}}, hardPalate));
    parts.push_back(planOf("Soft palate", PartRole::Pharynx, "FMA55021", plan,
                           {Vec3{-18, 28, 2}, Vec3{18, 86, 28}},
                           [soft](const Vec3& p) { return soft.distance(p); }));
    parts.push_back(planOf(
        "Oral cavity", PartRole::Pharynx, "FMA20292", plan, {Vec3{-24, 0, -34}, Vec3{24, 76, 24}},
        [soft, posture = plan.posture](const Vec3& p) { return oralCavity(soft, posture, p); }));
    return parts;
}

} // namespace carina
