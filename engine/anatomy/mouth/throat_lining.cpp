#include "engine/anatomy/mouth/throat_lining.h"

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/larynx/laryngeal_mucosa.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kLiningVoxel = millimetres(1.9);
constexpr double kThick = 2.6;
/// The constrictors' inner face is half their thickness within their middle.
constexpr double kInset = 1.7 + 1.0;
constexpr double kFatInWall = 2.5; ///< on each side, in an obese patient

/// The floor of the mouth ends between the arches, the cheeks behind the last teeth: they follow
/// jaw and blade, and the pharynx less. Reference millimetres behind the incisors.
constexpr double kFauces = 57.0;
constexpr double kEndOfCheeks = 46.0;
/// The pharynx' lining goes on outside that of the cheeks: where they are taken away from it, it is
/// seen instead of a gap.
constexpr double kBehindCheeks = 6.0;
constexpr double kApart = 1.2; ///< of the two there
/// The floor of the mouth goes on outside the pharynx' lining, up and down beside its edge: a jaw
/// that opens takes it down by 14 mm there in an adult, and a blade more. Reference millimetres.
constexpr double kOutsidePharynx = kThick + 0.4;
constexpr double kUpBesideFloor = 24.0;
constexpr double kDownBesideFloor = 10.0;
/// Half the width of what the soft palate closes above; beside it the pharynx' lining does.
constexpr double kBesidePalate = 15.0;
constexpr double kNoRoof = 1e3; ///< the cheeks': there are gums

/// A value at a place along a line, straight between those given and constant beyond them.
template <std::size_t kCount>
double valueAt(const std::array<std::array<double, 2>, kCount>& line, double x)
{
    if (x <= line.front()[0])
        return line.front()[1];
    for (std::size_t i = 1; i < kCount; ++i)
        if (x < line[i][0]) {
            const auto& a = line[i - 1];
            const auto& b = line[i];
            return a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
        }
    return line.back()[1];
}

/// Half the width of the mouth between the cheeks; all reference millimetres from the edge of the
/// upper incisors.
double halfMouth(double y)
{
    constexpr std::array<std::array<double, 2>, 5> kHalfWidth{
        {{-4.0, 24.0}, {12.0, 29.0}, {40.0, 30.5}, {50.0, 24.0}, {58.0, 18.5}}};
    return valueAt(kHalfWidth, y);
}
double floorOfMouth(Posture posture) { return posture == Posture::Rest ? -16.0 : -28.0; }

/// The air of the mouth between the cheeks.
double mouthAir(const Vec3& p, Posture posture)
{
    constexpr double kRoof = 13.0; // above the gums; the palate is higher
    const double floor = floorOfMouth(posture);
    const double sides = std::abs(p.x()) - halfMouth(p.y());
    const double ends = std::max(-14.0 - p.y(), p.y() - 62.0);
    return 0.85
           * roundedMax(roundedMax(sides, std::max(p.z() - kRoof, floor - p.z()), 8.0), ends, 4.0);
}

/// Below zero at the floor of the mouth, which goes with the tongue.
double inFloor(const Vec3& p, Posture posture)
{
    constexpr double kWithinTeeth = 22.0;
    constexpr double kWithinFauces = 3.0;
    constexpr double kHigh = 8.0;
    const double half = std::min(kWithinTeeth, halfMouth(p.y()) - kWithinFauces);
    return std::max(std::abs(p.x()) - half, p.z() - floorOfMouth(posture) - kHigh);
}

/// Below zero also beside its edges, where it goes on outside the pharynx' lining.
double inFloorAndBeside(const Vec3& p, Posture posture)
{
    constexpr double kBeside = 9.0; // the lining and its thickness, twice
    const double above = p.z() - floorOfMouth(posture);
    const double beside = std::max({std::abs(p.x()) - halfMouth(p.y()) - kBeside,
                                    above - kUpBesideFloor, -above - kDownBesideFloor});
    return std::min(inFloor(p, posture), beside);
}

/// Where the pharynx begins in front at a height, as if nothing lay in it. Above the larynx it is
/// drawn out as the throat is (BodyPlan), or in children it would not reach the mouth.
double frontOfPharynx(double z, double drawnOut)
{
    constexpr std::array<std::array<double, 2>, 7> kFront{{{-2.0, -2.0},
                                                           {8.0, -8.0},
                                                           {16.0, -22.0},
                                                           {24.0, -32.0},
                                                           {56.0, -30.0},
                                                           {64.0, -22.0},
                                                           {90.0, -4.0}}};
    return valueAt(kFront, z) * (1.0 + (drawnOut - 1.0) * easedStep(14.0, 34.0, z));
}

/// The air of the pharynx as if nothing lay in it: its back wall is that of the constrictors.
double pharynxAir(const Vec3& p, double fatness, double drawnOut)
{
    const PharynxSection s = pharynxSectionAt(p.z());
    const double middle = std::max(s.back - 0.9 * s.halfWidth, s.front);
    const double inset = kInset + kFatInWall * fatness;
    const Vec2 radii{s.halfWidth - inset, s.back - middle - kInset};
    const double round = ellipseDistance({p.x(), std::max(p.y() - middle, 0.0)}, radii);
    const double inFront = frontOfPharynx(p.z(), drawnOut) - p.y();
    const double rise =
        frontOfPharynx(p.z() + 0.5, drawnOut) - frontOfPharynx(p.z() - 0.5, drawnOut);
    const double front = std::min(0.6, 1.2 / std::hypot(1.0, rise)) * inFront;
    return roundedMax(round, std::max(front, p.z() - 84.0), 4.0);
}

/// Beside and behind the larynx it ends at the thyroid cartilage and at the floors of the piriform
/// fossae, which lie at the level of the cords: they are 25 mm high (Vadgaonkar 2024). Behind the
/// cricoid it goes on to the oesophagus. Millimetres of LarynxFrame.
double besideLarynx(const Vec3& p)
{
    constexpr std::array<std::array<double, 2>, 5> kHalfWidth{
        {{-12.0, 12.0}, {-4.0, 14.5}, {4.0, 16.0}, {30.0, 16.4}, {44.0, 30.0}}};
    /// Of the inner face of the thyroid's laminae, by y.
    constexpr std::array<std::array<double, 2>, 5> kLamina{
        {{-16.0, 0.0}, {-9.0, 4.4}, {0.0, 11.0}, {9.0, 15.0}, {15.0, 16.4}}};
    const double x = std::abs(p.x());
    const double floor = -23.0 + 12.0 * easedStep(6.5, 10.5, x);
    // Above their edges it widens over a small height. The slope is taken out of the distance, or
    // the lining would be thinner there than the grid it is drawn with, and have holes.
    const auto over = [](double z) { return 14.0 * easedStep(17.5, 26.0, z); };
    const double slope = over(p.z() + 0.5) - over(p.z() - 0.5);
    const double beyond = (x - valueAt(kLamina, p.y()) - over(p.z())) / std::hypot(1.0, slope);
    const double sides = std::max(x - valueAt(kHalfWidth, p.z()), beyond);
    return 0.8 * roundedMax(sides, 0.7 * (floor - p.z()), 3.0);
}

/// Below zero between the aryepiglottic folds and in front of them, up to the base of the tongue.
double inFrontOfEntrance(const Vec3& p, const Epiglottis& epiglottis)
{
    constexpr double kHalfWidth = 8.0;
    constexpr double kHigh = 46.0;
    constexpr double kFront = -45.0; // the floor of the mouth, below the tongue, begins there
    const double behind = p.y() - std::max(epiglottis.middleAt(p.z()) + 4.0, 0.0);
    return std::max({std::abs(p.x()) - kHalfWidth, behind, kFront - p.y(), p.z() - kHigh});
}

struct Lining {
    PharynxPlace place;
    LarynxFrame larynx;
    Epiglottis epiglottis;
    BodyPlan plan;

    /// Metres, below zero in the air.
    [[nodiscard]] double air(const Vec3& p_A) const
    {
        const double throat = roundedMax(
            place.least() * pharynxAir(place.inHis(p_A), plan.dimensions.fatness, plan.throat),
            larynx.unit() * besideLarynx(larynx.local(p_A)), 3.0 * plan.face);
        const double mouth = plan.face * mouthAir(plan.fromThroat(p_A), plan.posture);
        return roundedMin(throat, mouth, 6.0 * plan.face);
    }

    /// @param outward by which it lies outside the surface of the air, reference millimetres
    /// @param roof beyond this x it is closed above
    [[nodiscard]] double shell(const Vec3& p_A, double outward, double roof) const
    {
        const double half = 0.5 * kThick * plan.face;
        const double d = std::abs(air(p_A) - plan.face * outward - half) - half;
        // Open in front between the lips, and into the nose; the palate closes it above.
        const Vec3 p = plan.fromThroat(p_A);
        const double lips = 9.0 + 9.0 * easedStep(-9.0, -17.0, p.z()) - p.y();
        const double nose = std::min({p.z() - 10.5, 58.0 - p.y(), roof - std::abs(p.x())});
        const double open = std::max(lips, nose);
        // It meets the larynx and does not go on within it.
        const double meets = -larynx.unit() * (laryngealBody(larynx.local(p_A), epiglottis) + 1.0);
        // In front of the entrance of the larynx are the epiglottis and the tongue, which a blade
        // takes forward: what stayed there would hide the glottis.
        const double before = -larynx.unit() * inFrontOfEntrance(larynx.local(p_A), epiglottis);
        // Below it goes on into the oesophagus.
        const double end = larynx.unit() * (-21.0 - larynx.local(p_A).z());
        return roundedMax(d, std::max({plan.face * open, meets, before, end}), 1.5 * plan.face);
    }

    [[nodiscard]] double cheeksAndFloor(const Vec3& p_A) const
    {
        const Vec3 p = plan.fromThroat(p_A);
        const double floor = std::max(inFloorAndBeside(p, plan.posture), p.y() - kFauces);
        const double beyond = std::min(p.y() - kEndOfCheeks, floor);
        const double outward = kOutsidePharynx * easedStep(-2.0, 3.0, inFloor(p, plan.posture))
                               * easedStep(kEndOfCheeks - 2.0, kEndOfCheeks + 3.0, p.y());
        return roundedMax(shell(p_A, outward, kNoRoof), plan.face * beyond, 0.5 * plan.face);
    }

    [[nodiscard]] double pharynx(const Vec3& p_A) const
    {
        const Vec3 p = plan.fromThroat(p_A);
        const double floor = std::min(-inFloor(p, plan.posture), kFauces - p.y());
        const double before = std::max(kEndOfCheeks - kBehindCheeks - p.y(), floor);
        const double outward = kApart * easedStep(kEndOfCheeks + 2.0, kEndOfCheeks - 1.0, p.y());
        return roundedMax(shell(p_A, outward, kBesidePalate), plan.face * before, 0.5 * plan.face);
    }
};

} // namespace

std::vector<PartPlan> throatLining(const BodyPlan& plan, const LarynxFrame& larynx,
                                   const Epiglottis& epiglottis)
{
    const Lining lining{PharynxPlace{plan}, larynx, epiglottis, plan};
    Box bounds = larynx.inAnatomy(Box{Vec3{-20, -20, -28}, Vec3{20, 24, 10}});
    bounds.include(plan.inThroat({-36.0, 4.0, -42.0}));
    bounds.include(plan.inThroat({36.0, 92.0, 44.0}));
    const Implicit cheeks = [lining](const Vec3& p_A) { return lining.cheeksAndFloor(p_A); };
    const Implicit pharynx = [lining](const Vec3& p_A) { return lining.pharynx(p_A); };
    const Length voxel = 1e3 * plan.face * kLiningVoxel;
    return {{"Buccal mucosa", PartRole::Mucosa, "", {bounds, cheeks}, voxel},
            {"Pharyngeal mucosa", PartRole::Pharynx, "", {bounds, pharynx}, voxel}};
}

} // namespace carina
