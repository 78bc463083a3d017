#include "engine/anatomy/mouth/throat_lining.h"

#include "engine/anatomy/larynx/laryngeal_mucosa.h"
#include "engine/anatomy/mouth/throat_air.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kLiningVoxel = millimetres(1.9);
constexpr double kThick = 2.6;

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

/// Below zero at the floor of the mouth, which goes with the tongue.
double inFloor(const Vec3& p, Posture posture)
{
    constexpr double kWithinTeeth = 22.0;
    constexpr double kWithinFauces = 3.0;
    constexpr double kHigh = 8.0;
    const double half = std::min(kWithinTeeth, halfMouth_mm(p.y()) - kWithinFauces);
    return std::max(std::abs(p.x()) - half, p.z() - floorOfMouth_mm(posture) - kHigh);
}

/// Below zero also beside its edges, where it goes on outside the pharynx' lining.
double inFloorAndBeside(const Vec3& p, Posture posture)
{
    constexpr double kBeside = 9.0; // the lining and its thickness, twice
    const double above = p.z() - floorOfMouth_mm(posture);
    const double beside = std::max({std::abs(p.x()) - halfMouth_mm(p.y()) - kBeside,
                                    above - kUpBesideFloor, -above - kDownBesideFloor});
    return std::min(inFloor(p, posture), beside);
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
    ThroatAir air;
    LarynxFrame larynx;
    Epiglottis epiglottis;
    BodyPlan plan;

    /// @param outward by which it lies outside the surface of the air, reference millimetres
    /// @param roof beyond this x it is closed above
    [[nodiscard]] double shell(const Vec3& p_A, double outward, double roof) const
    {
        const double half = 0.5 * kThick * plan.face;
        const double d = std::abs(air.distance(p_A) - plan.face * outward - half) - half;
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
    const Lining lining{ThroatAir{plan, larynx}, larynx, epiglottis, plan};
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
