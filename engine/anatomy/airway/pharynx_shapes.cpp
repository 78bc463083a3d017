#include "engine/anatomy/airway/pharynx_shapes.h"

#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{

namespace
{

constexpr Length kPharynxVoxel = millimetres(1.8);
constexpr Length kOesophagusVoxel = millimetres(2.0);
constexpr double kHalfWall = 1.7;

double wall(const Vec3& p)
{
    const PharynxSection s = pharynxSectionAt(p.z());
    // Half an ellipse whose middle lies where the wall is widest.
    const double middle = std::max(s.back - 0.9 * s.halfWidth, s.front);
    const double shell = std::abs(ellipseDistance({p.x(), std::max(p.y() - middle, 0.0)},
                                                  {s.halfWidth, s.back - middle}))
                         - kHalfWall;
    const double ends = std::max(kPharynxFoot_mm - p.z(), p.z() - kPharynxVault_mm);
    return 0.8 * roundedMax(shell, std::max(s.front - p.y(), ends), 1.5);
}

/// One constrictor: the wall between two heights, a little apart from the next.
PartPlan constrictor(const char* name, const char* concept_, double from, double to,
                     const BodyPlan& plan)
{
    constexpr double kApart = 0.6;
    const PharynxPlace place{plan};
    Box bounds;
    for (const double z : {from - 3, to + 3})
        for (const Vec3& corner : {Vec3{-36, -20, z}, Vec3{36, 28, z}})
            bounds.include(place.inAnatomy(corner));
    const auto distance = [from, to, place](const Vec3& p_A) {
        const Vec3 p = place.inHis(p_A);
        const double band = std::max(from + kApart - p.z(), p.z() - to + kApart);
        return place.least() * roundedMax(wall(p), band, 1.0);
    };
    return {
        name, PartRole::Pharynx, concept_, {bounds, distance}, 1e3 * plan.airway * kPharynxVoxel};
}

/// Centre line of the oesophagus from the cricoid to the diaphragm, in reference millimetres of the
/// chest.
constexpr std::array<std::array<double, 3>, 12> kOesophagus{{{0, -12, 102},
                                                             {0, -9, 75},
                                                             {0, -6, 50},
                                                             {0, 0, 25},
                                                             {0.5, 9, 0},
                                                             {0.5, 11, -25},
                                                             {0.5, 11, -50},
                                                             {0.5, 9.5, -75},
                                                             {1, 4, -100},
                                                             {4, -5.5, -125},
                                                             {9, -19, -150},
                                                             {14, -31, -168}}};

PartPlan oesophagus(const BodyPlan& plan)
{
    constexpr double kWide = 8.2;
    constexpr double kThin = 4.4;
    const RigidTransform X_WA = windpipeInAnatomy().inverse();
    const double top = plan.dimensions.tracheaLength.si - 2.0 * plan.airway;
    std::vector<Vec3> line;
    for (const auto& p : kOesophagus) {
        Vec3 p_A = plan.inChest({p[0], p[1], p[2]});
        if (p[2] >= 0.0) { // behind the trachea, from the level of the cricoid down
            const double height = top * p[2] / kOesophagus.front()[2];
            const double behind =
                0.5 * plan.dimensions.upperTrachea.sagittal.si + (kThin + 1.0) * plan.airway;
            const Vec3 p_W{p_A.x(), behind, height};
            const Vec3 there = X_WA.inverse() * p_W;
            p_A = {there.x(), std::max(there.y(), p_A.y()), there.z()};
        }
        line.push_back(p_A);
    }
    std::vector<StrandPoint> points;
    const std::vector<Vec3> smooth = smoothThrough(line, 4);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        const Vec3 along = smooth[std::min(i + 1, smooth.size() - 1)] - smooth[i > 0 ? i - 1 : 0];
        points.push_back({smooth[i], kWide * plan.chest, kThin * plan.chest,
                          along.cross(Vec3::UnitX()).normalized()});
    }
    return {"Oesophagus", PartRole::Oesophagus, "FMA7131", Strand{std::move(points)}.shape(),
            1e3 * plan.chest * kOesophagusVoxel};
}

} // namespace

std::vector<PartPlan> pharynxAndOesophagus(const BodyPlan& plan)
{
    return {constrictor("Superior pharyngeal constrictor", "FMA46621", 47, 92, plan),
            constrictor("Middle pharyngeal constrictor", "FMA46622", 26, 47, plan),
            constrictor("Inferior pharyngeal constrictor", "FMA46623", -22, 26, plan),
            oesophagus(plan)};
}

} // namespace carina
