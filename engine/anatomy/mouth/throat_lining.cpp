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

/// The mouth ends and the pharynx begins between the arches: the one follows the jaw, the other
/// does not. Reference millimetres behind the incisors.
constexpr double kFauces = 57.0;

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

/// The air of the mouth between the cheeks, reference millimetres from the edge of the upper
/// incisors.
double mouthAir(const Vec3& p, Posture posture)
{
    constexpr std::array<std::array<double, 2>, 5> kHalfWidth{
        {{-4.0, 24.0}, {12.0, 29.0}, {40.0, 30.5}, {50.0, 24.0}, {58.0, 18.5}}};
    constexpr double kRoof = 13.0; // above the gums; the palate is higher
    const double floor = posture == Posture::Rest ? -16.0 : -28.0;
    const double sides = std::abs(p.x()) - valueAt(kHalfWidth, p.y());
    const double ends = std::max(-14.0 - p.y(), p.y() - 62.0);
    return 0.85
           * roundedMax(roundedMax(sides, std::max(p.z() - kRoof, floor - p.z()), 8.0), ends, 4.0);
}

/// The air of the pharynx as if nothing lay in it: its back wall is that of the constrictors.
double pharynxAir(const Vec3& p, double fatness)
{
    constexpr std::array<std::array<double, 2>, 7> kFront{{{-2.0, -2.0},
                                                           {8.0, -8.0},
                                                           {16.0, -22.0},
                                                           {24.0, -32.0},
                                                           {56.0, -30.0},
                                                           {64.0, -22.0},
                                                           {90.0, -4.0}}};
    const PharynxSection s = pharynxSectionAt(p.z());
    const double middle = std::max(s.back - 0.9 * s.halfWidth, s.front);
    const double inset = kInset + kFatInWall * fatness;
    const Vec2 radii{s.halfWidth - inset, s.back - middle - kInset};
    const double round = ellipseDistance({p.x(), std::max(p.y() - middle, 0.0)}, radii);
    const double front = 0.6 * (valueAt(kFront, p.z()) - p.y());
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
    const double over = 14.0 * easedStep(17.5, 26.0, p.z());
    const double half = std::min(valueAt(kHalfWidth, p.z()), valueAt(kLamina, p.y()) + over);
    return 0.8 * roundedMax(x - half, 0.7 * (floor - p.z()), 3.0);
}

/// Below zero between the aryepiglottic folds and in front of them, up to the base of the tongue.
double inFrontOfEntrance(const Vec3& p, const Epiglottis& epiglottis)
{
    constexpr double kHalfWidth = 8.0;
    constexpr double kHigh = 46.0;
    const double behind = p.y() - std::max(epiglottis.middleAt(p.z()) + 4.0, 0.0);
    return std::max({std::abs(p.x()) - kHalfWidth, behind, p.z() - kHigh});
}

struct Lining {
    PharynxPlace place;
    LarynxFrame larynx;
    Epiglottis epiglottis;
    BodyPlan plan;

    /// Metres, below zero in the air.
    [[nodiscard]] double air(const Vec3& p_A) const
    {
        const double throat =
            roundedMax(place.least() * pharynxAir(place.inHis(p_A), plan.dimensions.fatness),
                       larynx.unit() * besideLarynx(larynx.local(p_A)), 3.0 * plan.face);
        const double mouth = plan.face * mouthAir(plan.fromThroat(p_A), plan.posture);
        return roundedMin(throat, mouth, 6.0 * plan.face);
    }

    [[nodiscard]] double shell(const Vec3& p_A) const
    {
        const double half = 0.5 * kThick * plan.face;
        const double d = std::abs(air(p_A) - half) - half;
        // Open in front between the lips, and into the nose; the palate closes it above.
        const Vec3 p = plan.fromThroat(p_A);
        const double lips = 9.0 + 9.0 * easedStep(-9.0, -17.0, p.z()) - p.y();
        const double open = std::max(lips, std::min(p.z() - 10.5, 58.0 - p.y()));
        // It meets the larynx and does not go on within it.
        const double meets = -larynx.unit() * (laryngealBody(larynx.local(p_A), epiglottis) + 1.0);
        // In front of the entrance of the larynx are the epiglottis and the tongue, which a blade
        // takes forward: what stayed there would hide the glottis.
        const double before = -larynx.unit() * inFrontOfEntrance(larynx.local(p_A), epiglottis);
        // Below it goes on into the oesophagus.
        const double end = larynx.unit() * (-21.0 - larynx.local(p_A).z());
        return roundedMax(d, std::max({plan.face * open, meets, before, end}), 1.5 * plan.face);
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
    const auto part = [&](const char* name, PartRole role, auto beyond) {
        return PartPlan{name,
                        role,
                        "",
                        {bounds,
                         [lining, beyond](const Vec3& p_A) {
                             const double cut = beyond(lining.plan.fromThroat(p_A).y());
                             return roundedMax(lining.shell(p_A), lining.plan.face * cut,
                                               0.5 * lining.plan.face);
                         }},
                        1e3 * plan.face * kLiningVoxel};
    };
    return {part("Buccal mucosa", PartRole::Mucosa, [](double y) { return y - kFauces; }),
            part("Pharyngeal mucosa", PartRole::Pharynx, [](double y) { return kFauces - y; })};
}

} // namespace carina
