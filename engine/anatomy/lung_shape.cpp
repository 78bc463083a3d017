#include "engine/anatomy/lung_shape.h"

#include <cmath>
#include <utility>

namespace carina
{

namespace
{

/// Lung shapes are written in millimetres of the adult, towards the lung's own side: x is positive
/// away from the midline in both lungs.
constexpr double kAdultMillimetre = 1e-3;

/// Free way between an airway and the lung beside it, in the adult.
constexpr double kClearance = 1.5;

struct Form {
    Vec3 base; ///< centre of the widest section
    Vec3 apex; ///< top
    double halfWidth;
    double halfDepth;
    Vec3 dome; ///< centre of the diaphragm's half
    Vec3 domeRadii;
    Vec3 heart;
    Vec3 heartRadii;
};

const Form kRight{{55.0, -15.0, -132.0},
                  {34.0, 13.0, 72.0},
                  56.0,
                  75.5,
                  {57.0, -24.5, -181.0},
                  {79.0, 93.0, 85.0},
                  {-15.0, -42.0, -66.0},
                  {53.0, 43.0, 60.0}};
const Form kLeft{{55.0, -15.0, -140.0},
                 {34.0, 13.0, 70.0},
                 56.0,
                 75.5,
                 {57.0, -24.5, -194.0},
                 {79.0, 93.0, 85.0},
                 {19.0, -47.0, -72.0},
                 {53.0, 46.0, 62.0}};

/// The space under the ribs: a section of rounded corners that narrows to the apex.
double underRibs(const Form& form, const Vec3& p)
{
    const double height = form.apex.z() - form.base.z();
    const double up = (p.z() - form.base.z()) / height;
    const double lean = std::max(up, 0.0);
    const double x = (p.x() - form.base.x() - lean * (form.apex.x() - form.base.x()));
    const double y = (p.y() - form.base.y() - lean * (form.apex.y() - form.base.y()));
    const double across =
        std::pow(std::abs(x) / form.halfWidth, 2.4) + std::pow(std::abs(y) / form.halfDepth, 2.4);
    const double e = std::sqrt(std::pow(across, 2.0 / 2.4) + up * up);
    return (e - 1.0) * form.halfWidth;
}

/// Everything in the middle of the chest.
double mediastinum(const Form& form, const Vec3& p)
{
    const double heart = ellipsoidDistance(p - form.heart, form.heartRadii);
    const double vessels = rodDistance(p, {0.0, -26.0, -20.0}, {0.0, -12.0, 120.0}, 25.0, 19.0);
    const double hila = rodDistance(p, {0.0, -2.0, -70.0}, {0.0, -2.0, 10.0}, 22.0, 21.0);
    const double spine = rodDistance(p, {0.0, 58.0, -260.0}, {0.0, 44.0, 140.0}, 32.0, 27.0);
    return roundedMin(roundedMin(heart, vessels, 14.0), roundedMin(hila, spine, 14.0), 14.0);
}

double diaphragm(const Form& form, const Vec3& p)
{
    Vec3 q = p - form.dome;
    q.z() = std::max(q.z(), 0.0); // straight down below the dome's widest place
    return ellipsoidDistance(q, form.domeRadii);
}

/// Depth of the grooves between the lobes.
double fissures(Side side, const Vec3& p)
{
    constexpr double kDepth = 3.0;
    constexpr double kHalfWidth = 3.2;
    const auto groove = [](double off) {
        return kDepth * std::exp(-off * off / (kHalfWidth * kHalfWidth));
    };
    // Oblique: from the fourth vertebra at the back down to the sixth cartilage in front.
    const Vec3 oblique = Vec3{0.0, -130.0, 110.0}.normalized();
    const double aboveOblique = (p - Vec3{0.0, 55.0, 15.0}).dot(oblique);
    double depth = groove(aboveOblique);
    if (side == Side::Right) {
        // Horizontal: in front of the oblique one, at the fourth cartilage.
        const double aboveHorizontal = p.z() + 42.0 + 0.1 * p.y();
        depth = std::max(depth, easedStep(-2.0, 2.0, aboveOblique) * groove(aboveHorizontal));
    }
    return depth;
}

double lungDistance(Side side, const Vec3& p)
{
    const Form& form = side == Side::Right ? kRight : kLeft;
    constexpr double kFillet = 9.0;
    double d = underRibs(form, p);
    d = roundedMax(d, -diaphragm(form, p), 1.7 * kFillet);
    d = roundedMax(d, -mediastinum(form, p), kFillet);
    d = roundedMax(d, 5.0 - p.x(), kFillet);
    if (side == Side::Left) // the cardiac notch
        d = roundedMax(d, -ellipsoidDistance(p - Vec3{14.0, -98.0, -88.0}, {42.0, 42.0, 34.0}),
                       kFillet);
    return d + fissures(side, p);
}

} // namespace

ImplicitShape lungShape(Side side, double size, Implicit outsideLungs)
{
    const double sign = side == Side::Right ? -1.0 : 1.0;
    const double unit = kAdultMillimetre * size;
    Box bounds;
    bounds.include(unit * Vec3{sign * 2.0, -105.0, -200.0});
    bounds.include(unit * Vec3{sign * 125.0, 75.0, 85.0});
    const auto distance = [side, sign, unit, outside = std::move(outsideLungs)](const Vec3& p_A) {
        const Vec3 p = p_A / unit;
        const double lung = lungDistance(side, {sign * p.x(), p.y(), p.z()});
        return unit * roundedMax(lung, kClearance - outside(p_A) / unit, 4.0);
    };
    return {bounds, distance};
}

Vec3 hilum(Side side, double size)
{
    const double unit = kAdultMillimetre * size;
    return side == Side::Right ? unit * Vec3{-24.0, 0.0, -20.0} : unit * Vec3{40.0, 0.0, -34.0};
}

} // namespace carina
