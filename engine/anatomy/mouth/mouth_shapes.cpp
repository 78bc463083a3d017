#include "engine/anatomy/mouth/mouth_shapes.h"

#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/mouth/fauces_shape.h"
#include "engine/anatomy/mouth/lip_shape.h"
#include "engine/anatomy/mouth/throat_lining.h"
#include "engine/anatomy/mouth/tongue_root.h"
#include "engine/anatomy/mouth/tongue_shape.h"
#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace carina
{
namespace
{

/// All shapes here are in reference millimetres (BodyPlan) from the edge of the upper incisors, of
/// the closed mouth.

constexpr Length kMouthVoxel = millimetres(1.6);

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

/// A ridge along the necks of the teeth of one jaw, of the left half: their arch, half its height
/// and half its thickness.
Strand ridge(std::span<const Vec3> arch, double high, double thick)
{
    std::vector<StrandPoint> points;
    const std::vector<Vec3> line = smoothThrough(arch, 3);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 along = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
        points.push_back({line[i], high, thick, along.cross(Vec3::UnitZ()).normalized()});
    }
    return Strand{std::move(points)};
}

constexpr double kGumHigh = 4.6;
constexpr double kGumThick = 5.0;

Strand upperGum()
{
    return ridge(std::array{Vec3{-4.3, 4.6, 12.6}, Vec3{4.3, 4.6, 12.6}, Vec3{11, 6.8, 13},
                            Vec3{17, 10.8, 14}, Vec3{20.3, 18, 14.6}, Vec3{23.2, 24.3, 15.4},
                            Vec3{24.3, 33, 17}, Vec3{24, 42, 19.5}, Vec3{23, 47.5, 20.5}},
                 kGumHigh, kGumThick);
}

Strand lowerGum()
{
    return ridge(std::array{Vec3{-3, 9.4, -12}, Vec3{3, 9.4, -12}, Vec3{8.3, 10, -12},
                            Vec3{13, 13, -11.5}, Vec3{17.4, 18.8, -10.2}, Vec3{20.3, 25.5, -9},
                            Vec3{23, 33.5, -6.5}, Vec3{26.3, 45, -2.5}, Vec3{26.2, 51, -0.5}},
                 kGumHigh, 0.86 * kGumThick);
}

/// Converts a shape within a box to A.
PartPlan planOf(std::string name, PartRole role, const char* concept_, const BodyPlan& plan,
                const Box& bounds_mm, Length voxel, Implicit local)
{
    const Box bounds{plan.inThroat(bounds_mm.min), plan.inThroat(bounds_mm.max)};
    return {std::move(name),
            role,
            concept_,
            {bounds, [plan, local = std::move(local)](
                         const Vec3& p_A) { return plan.face * local(plan.fromThroat(p_A)); }},
            1e3 * plan.face * voxel};
}

Vec3 mirrored(const Vec3& p) { return {std::abs(p.x()), p.y(), p.z()}; }

void addTo(std::vector<PartPlan>& parts, std::vector<PartPlan> more)
{
    parts.insert(parts.end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

void addGums(std::vector<PartPlan>& parts, const BodyPlan& plan)
{
    const auto onLower = [&](PartPlan part) {
        part.shape = onJaw(plan, std::move(part.shape));
        return part;
    };
    parts.push_back(
        planOf("Gingiva of upper jaw", PartRole::Mucosa, "FMA59763", plan,
               {Vec3{-32, -4, 5}, Vec3{32, 54, 28}}, kMouthVoxel,
               [gum = upperGum()](const Vec3& p) { return gum.distance(mirrored(p)); }));
    parts.push_back(
        onLower(planOf("Gingiva of lower jaw", PartRole::Mucosa, "FMA59764", plan,
                       {Vec3{-34, 0, -20}, Vec3{34, 58, 8}}, kMouthVoxel,
                       [gum = lowerGum()](const Vec3& p) { return gum.distance(mirrored(p)); })));
}

} // namespace

std::vector<PartPlan> mouth(const BodyPlan& plan)
{
    const LarynxFrame larynx{plan.dimensions};
    const Epiglottis epiglottis{plan};
    const Tongue tongue{plan, larynx, epiglottis};
    std::vector<PartPlan> parts;
    parts.push_back({"Tongue",
                     PartRole::Tongue,
                     "FMA54640",
                     {tongue.bounds(), [tongue](const Vec3& p_A) { return tongue.distance(p_A); }},
                     1e3 * plan.face * kMouthVoxel});
    parts.push_back(tongueRoot(plan, larynx, epiglottis, tongue));
    parts.push_back({"Median glosso-epiglottic fold", PartRole::Mucosa, "", tongue.medianFold(),
                     1e3 * plan.face * millimetres(0.8)});
    parts.push_back(planOf("Hard palate", PartRole::Pharynx, "FMA55023", plan,
                           {Vec3{-26, -2, 5}, Vec3{26, 52, 26}}, kMouthVoxel, hardPalate));
    addTo(parts, Fauces{plan, larynx, tongue}.parts());
    addGums(parts, plan);
    addTo(parts, Lips{plan}.parts());
    addTo(parts, throatLining(plan, larynx, epiglottis));
    return parts;
}

} // namespace carina
