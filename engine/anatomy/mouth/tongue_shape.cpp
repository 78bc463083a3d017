#include "engine/anatomy/mouth/tongue_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kHalfWidth = 19.0;
constexpr double kFatInTongue = 2.0; ///< on each side, in an obese patient
constexpr double kRound = 11.0;
constexpr double kHalfFold = 0.9;      ///< at its edge
constexpr double kFoldThickens = 0.35; ///< for each millimetre below that

/// The section in front of the base, in reference millimetres (BodyPlan) from the edge of the upper
/// incisors: from the base over the dorsum to the tip.
constexpr std::array<std::array<double, 2>, 7> kRestAbove{
    {{67.5, -8}, {63, 3}, {55, 11}, {44, 14.5}, {30, 14}, {18, 9.5}, {9, 0}}};
constexpr std::array<std::array<double, 2>, 4> kRestBelow{
    {{11, -7}, {24, -14}, {40, -18}, {52, -24}}};
constexpr std::array<std::array<double, 2>, 7> kHeldAbove{
    {{50, -16}, {49, -12.5}, {45, -10}, {38, -9.5}, {30, -11.5}, {24.5, -14}, {22, -16.5}}};
constexpr std::array<std::array<double, 2>, 4> kHeldBelow{
    {{27.5, -20}, {33, -29}, {38, -38}, {46, -45}}};

Vec2 sagittal(const Vec3& p) { return {p.y(), p.z()}; }

} // namespace

Tongue::Tongue(const BodyPlan& plan, const LarynxFrame& larynx, const Epiglottis& epiglottis)
    : m_larynx(larynx),
      m_epiglottis(epiglottis),
      m_unit(plan.face),
      m_halfWidth(kHalfWidth + kFatInTongue * plan.dimensions.fatness)
{
    const auto behind = [&](double inFront, double z) {
        return sagittal(larynx.inAnatomy(Vec3{0.0, epiglottis.middleAt(z) - inFront, z}));
    };
    const auto inFace = [&](const std::array<double, 2>& p) {
        return sagittal(plan.inThroat({0.0, p[0], p[1]}));
    };
    const bool rest = plan.posture == Posture::Rest;
    std::vector<Vec2> line;
    for (const auto& p : rest ? kRestBelow : kHeldBelow)
        line.push_back(inFace(p));
    for (const Vec2& p : {behind(5.0, 9.0), behind(0.8, 12.0), behind(0.8, 15.6), behind(3.6, 15.8),
                          behind(7.2, 20.0), behind(8.6, 26.0), behind(9.0, 31.0)})
        line.push_back(p);
    for (const auto& p : rest ? kRestAbove : kHeldAbove)
        line.push_back(inFace(p));
    line.push_back(line.front());
    m_outline = cornersCut(std::move(line), 2);
    m_outline.pop_back();
    m_fold = {behind(0.5, 28.0), behind(0.5, 12.0), behind(10.0, 12.0), behind(10.5, 27.5),
              behind(7.5, 24.0), behind(4.5, 21.8), behind(2.5, 23.0)};
    m_base = larynx.inAnatomy(Vec3{0.0, epiglottis.middleAt(20.0), 20.0});
    m_sulcus = plan.inFace({0.0, rest ? 50.0 : 42.0, 0.0}).y();
    for (const Vec2& p : m_outline) {
        m_bounds.include(Vec3{-1.1 * m_halfWidth * m_unit, p.x(), p.y()});
        m_bounds.include(Vec3{1.1 * m_halfWidth * m_unit, p.x(), p.y()});
    }
    m_bounds.min -= Vec3::Constant(2.0 * m_unit);
    m_bounds.max += Vec3::Constant(2.0 * m_unit);
}

/// Of ours: as wide as the valleculae are between their folds, and as deep as the floor that goes
/// with the epiglottis (vallecula) lets them be. In front of the epiglottis, millimetres of
/// LarynxFrame.
double Tongue::hollow(const Vec3& p_A) const
{
    const Vec3 p = m_larynx.local(p_A);
    const double inFront = m_epiglottis.middleAt(p.z()) - p.y();
    const Vec3 from{std::abs(p.x()) - 5.5, inFront - 4.2, p.z() - 18.5};
    return 0.9 * m_larynx.unit() * ellipsoidDistance(from, {4.2, 3.6, 5.2});
}

double Tongue::distance(const Vec3& p_A) const
{
    const double x = std::abs(p_A.x()) / m_unit;
    const double section = polygonDistance(sagittal(p_A), m_outline) / m_unit;
    // The base is narrower, and the tip rounds off.
    const double forward = (m_outline[m_outline.size() / 2].x() - p_A.y()) / m_unit;
    const double tip = easedStep(18.0, 42.0, forward);
    const double base = easedStep(12.0, -4.0, (p_A.z() - m_base.z()) / m_unit);
    const double half = m_halfWidth - 4.0 * tip - 2.0 * base;
    const double groove =
        0.9 * std::exp(-0.16 * x * x) * easedStep(0.0, 8.0, (m_sulcus - p_A.y()) / m_unit);
    const double whole = m_unit * 0.9 * roundedMax(section + groove, x - half, kRound);
    return roundedMax(whole, -hollow(p_A), 1.5 * m_larynx.unit());
}

ImplicitShape Tongue::medianFold() const
{
    Box bounds;
    for (const Vec2& p : m_fold) {
        bounds.include(Vec3{-3.0 * m_unit, p.x() - 2.0 * m_unit, p.y() - 2.0 * m_unit});
        bounds.include(Vec3{3.0 * m_unit, p.x() + 2.0 * m_unit, p.y() + 2.0 * m_unit});
    }
    return {bounds, [fold = m_fold, unit = m_unit](const Vec3& p_A) {
                const double section = polygonDistance(sagittal(p_A), fold);
                const double half = kHalfFold * unit + kFoldThickens * std::max(-section, 0.0);
                return roundedMax(section, std::abs(p_A.x()) - half, 1.2 * unit);
            }};
}

} // namespace carina
