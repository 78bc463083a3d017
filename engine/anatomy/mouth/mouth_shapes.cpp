#include "engine/anatomy/mouth/mouth_shapes.h"

#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/mouth/throat_lining.h"
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
constexpr Length kFineVoxel = millimetres(1.3);

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

/// A point of a band in the midline or on the left side.
struct BandPoint {
    Vec3 p;
    double wide, thin;
};

/// A strand whose thickness lies in the plane of `across`.
Strand bandAcross(std::span<const BandPoint> points, const Vec3& across)
{
    std::vector<StrandPoint> strand;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 along =
            points[std::min(i + 1, points.size() - 1)].p - points[i > 0 ? i - 1 : 0].p;
        strand.push_back(
            {points[i].p, points[i].wide, points[i].thin, along.cross(across).normalized()});
    }
    return Strand{std::move(strand)};
}

/// The velum with the uvula, which hangs free in the midline.
struct SoftPalate {
    Strand velum = bandAcross(
        std::array{BandPoint{{0, 44, 19.5}, 16.5, 2.4}, BandPoint{{0, 52, 21}, 17.0, 2.8},
                   BandPoint{{0, 59, 19}, 17.5, 3.0}, BandPoint{{0, 65, 14.5}, 17.0, 2.8},
                   BandPoint{{0, 69, 9}, 15.5, 2.2}},
        Vec3::UnitX());

    [[nodiscard]] double distance(const Vec3& p) const
    {
        // Its free edge is an arch: higher beside the uvula than at its feet.
        const double x = std::abs(p.x());
        const Vec3 lifted{p.x(), p.y() + 0.006 * x * x, p.z() - 0.012 * x * x};
        return 0.85 * velum.distance(lifted);
    }
};

/// Where it hangs from the velum. A throat that is drawn out takes that place along but does not
/// draw out the uvula: in an infant it would be a leaf three times as deep as it is wide.
const Vec3 kUvulaRoot{0.0, 67.5, 11.0};

/// A cone with a round point (Gray 1918), 12 mm long below the velum: 10 to 15 in grown people.
double uvula(const Vec3& p)
{
    return std::min(rodDistance(p, kUvulaRoot, {0, 71.2, 3.5}, 3.6, 2.9),
                    rodDistance(p, {0, 71.2, 3.5}, {0, 72.6, -2.8}, 2.9, 1.8));
}

/// Metres in one of its millimetres. In children it is as small as their windpipe for their face:
/// of ours, no figure was found. In proportion to the face it hid what lies behind it.
double unitOfUvula(const BodyPlan& plan) { return std::min(plan.face, plan.airway); }

/// The middle of a fold of mucosa on the left side.
using Fold = std::vector<Vec3>;
constexpr double kPillar = 2.2; ///< half the thickness of a pillar of the fauces

Fold palatoglossalArch(Posture posture)
{
    const double foot = posture == Posture::Rest ? -4.0 : -17.0;
    return smoothThrough(std::array{Vec3{7, 58, 17}, Vec3{13.5, 56, 14.5}, Vec3{17.8, 53, 7},
                                    Vec3{18.6, 50, -3}, Vec3{17.5, 47, foot}},
                         4);
}

Fold palatopharyngealArch()
{
    return smoothThrough(std::array{Vec3{3, 69, 9.5}, Vec3{9.5, 68.5, 9}, Vec3{14.5, 68, 3},
                                    Vec3{16.6, 68, -8}, Vec3{19.5, 69, -22}},
                         4);
}

/// The palatine tonsil between both arches, with its crypts left out.
double tonsil(const Vec3& p) { return ellipsoidDistance(p - Vec3{18.6, 60, -4}, {4.2, 6.0, 10.0}); }

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

/// A lip from the midline to its corner, of the left half; lips meet where the mouth is shut.
double lip(const Vec3& p, std::span<const Vec3> line)
{
    const std::array radii{4.6, 4.8, 4.4, 3.6, 2.6};
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        nearest = std::min(nearest, rodDistance(p, line[i], line[i + 1], radii[i], radii[i + 1]));
    return nearest;
}
const std::array kUpperLip{Vec3{0, -8.0, 6.8}, Vec3{6, -7.2, 7.6}, Vec3{14, -3.0, 5.2},
                           Vec3{20.5, 3.0, 0.5}, Vec3{25.5, 10.0, -5.5}};
const std::array kLowerLip{Vec3{0, -5.2, -8.4}, Vec3{6, -4.6, -8.4}, Vec3{14, -0.8, -7.6},
                           Vec3{20.5, 4.6, -6.0}, Vec3{25.5, 10.5, -4.0}};

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

void addPalate(std::vector<PartPlan>& parts, const BodyPlan& plan)
{
    parts.push_back(planOf("Hard palate", PartRole::Pharynx, "FMA55023", plan,
                           {Vec3{-26, -2, 5}, Vec3{26, 52, 26}}, kMouthVoxel, hardPalate));
    parts.push_back(planOf("Soft palate", PartRole::Pharynx, "FMA55021", plan,
                           {Vec3{-22, 36, 2}, Vec3{22, 80, 30}}, kMouthVoxel,
                           [soft = SoftPalate{}](const Vec3& p) { return soft.distance(p); }));
    const Vec3 p_A_root = plan.inThroat(kUvulaRoot);
    const double unit = unitOfUvula(plan);
    const auto inAnatomy = [&](const Vec3& p) { return Vec3{p_A_root + unit * (p - kUvulaRoot)}; };
    const Implicit hanging = [p_A_root, unit](const Vec3& p_A) {
        return unit * uvula((p_A - p_A_root) / unit + kUvulaRoot);
    };
    parts.push_back({"Uvula",
                     PartRole::Pharynx,
                     "",
                     {{inAnatomy({-5, 62, -6}), inAnatomy({5, 78, 16})}, hanging},
                     1e3 * unit * kFineVoxel});
}

/// The pillars of the fauces with the tonsils: parts of the pharynx' wall, with which they move.
void addFauces(std::vector<PartPlan>& parts, const BodyPlan& plan)
{
    const Fold front = palatoglossalArch(plan.posture);
    const Fold back = palatopharyngealArch();
    for (const double sign : {1.0, -1.0}) {
        const std::string side = sign > 0.0 ? "Left " : "Right ";
        const Box box = sign > 0.0 ? Box{Vec3{0, 40, -30}, Vec3{26, 78, 24}}
                                   : Box{Vec3{-26, 40, -30}, Vec3{0, 78, 24}};
        const auto add = [&](const char* name, Implicit half) {
            parts.push_back(planOf(side + name, PartRole::Pharynx, "", plan, box, kFineVoxel,
                                   [sign, half = std::move(half)](const Vec3& p) {
                                       return half({sign * p.x(), p.y(), p.z()});
                                   }));
        };
        for (const auto& [name, fold] :
             {std::pair{"palatoglossal arch", front}, std::pair{"palatopharyngeal arch", back}})
            add(name, [line = fold, radii = std::vector<double>(fold.size(), kPillar)](
                          const Vec3& p) { return tubeDistance(p, line, radii); });
        add("palatine tonsil", tonsil);
    }
}

void addGumsAndLips(std::vector<PartPlan>& parts, const BodyPlan& plan)
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
    const Box lips{Vec3{-31, -16, -16}, Vec3{31, 18, 14}};
    parts.push_back(planOf("Upper lip", PartRole::Mucosa, "", plan, lips, kMouthVoxel,
                           [](const Vec3& p) { return lip(mirrored(p), kUpperLip); }));
    parts.push_back(onLower(planOf("Lower lip", PartRole::Mucosa, "", plan, lips, kMouthVoxel,
                                   [](const Vec3& p) { return lip(mirrored(p), kLowerLip); })));
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
    parts.push_back({"Median glosso-epiglottic fold", PartRole::Mucosa, "", tongue.medianFold(),
                     1e3 * plan.face * millimetres(0.8)});
    addPalate(parts, plan);
    addFauces(parts, plan);
    addGumsAndLips(parts, plan);
    std::vector<PartPlan> lining = throatLining(plan, larynx, epiglottis);
    parts.insert(parts.end(), std::make_move_iterator(lining.begin()),
                 std::make_move_iterator(lining.end()));
    return parts;
}

} // namespace carina
