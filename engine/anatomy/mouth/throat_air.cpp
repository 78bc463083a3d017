#include "engine/anatomy/mouth/throat_air.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

/// The constrictors' inner face is half their thickness within their middle.
constexpr double kInset = 1.7 + 1.0;
constexpr double kFatInWall = 2.5; ///< on each side, in an obese patient

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

/// The air of the mouth between the cheeks, in reference millimetres from the edge of the upper
/// incisors.
double mouthAir(const Vec3& p, Posture posture)
{
    constexpr double kRoof = 13.0; // above the gums; the palate is higher
    const double floor = floorOfMouth_mm(posture);
    const double sides = std::abs(p.x()) - halfMouth_mm(p.y());
    const double ends = std::max(-14.0 - p.y(), p.y() - 62.0);
    return 0.85
           * roundedMax(roundedMax(sides, std::max(p.z() - kRoof, floor - p.z()), 8.0), ends, 4.0);
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

} // namespace

ThroatAir::ThroatAir(const BodyPlan& plan, const LarynxFrame& larynx)
    : m_place(plan), m_larynx(larynx), m_plan(plan)
{
}

double ThroatAir::distance(const Vec3& p_A) const
{
    const double pharynx =
        m_place.least() * pharynxAir(m_place.inHis(p_A), m_plan.dimensions.fatness, m_plan.throat);
    const double throat =
        roundedMax(pharynx, m_larynx.unit() * besideLarynx(m_larynx.local(p_A)), 3.0 * m_plan.face);
    const double mouth = m_plan.face * mouthAir(m_plan.fromThroat(p_A), m_plan.posture);
    return roundedMin(throat, mouth, 6.0 * m_plan.face);
}

double halfMouth_mm(double y_mm)
{
    constexpr std::array<std::array<double, 2>, 5> kHalfWidth{
        {{-4.0, 24.0}, {12.0, 29.0}, {40.0, 30.5}, {50.0, 24.0}, {58.0, 18.5}}};
    return valueAt(kHalfWidth, y_mm);
}

double floorOfMouth_mm(Posture posture) { return posture == Posture::Rest ? -16.0 : -28.0; }

} // namespace carina
