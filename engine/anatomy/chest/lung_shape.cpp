#include "engine/anatomy/chest/lung_shape.h"

#include "engine/anatomy/chest/diaphragm_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{

namespace
{

constexpr Length kLungVoxel = millimetres(3.3);

/// Lungs are given in reference millimetres (BodyPlan) from the lowest edge of the trachea; x is
/// positive away from the midline for both lungs.

/// Clearance between an airway and the lung beside it, and from the middle of the diaphragm.
constexpr double kClearance = 2.5;
constexpr double kAboveDiaphragm = 3.4;
constexpr double kAboveDomes = -65.0; ///< height above which the diaphragm is far away
constexpr double kHalfFissure = 0.25;
/// Further out than surfaces are looked for.
constexpr double kFarFromFissure = 60.0;

/// A rod beside which the lung ends: y of its lower and upper end, and its radii there.
struct Rod {
    double lowerY, upperY;
    double lowerRadius, upperRadius;
};

struct Form {
    Vec3 base; ///< centre of the widest section
    Vec3 apex; ///< top
    double halfWidth;
    double halfDepth;
    double corners; ///< exponent of the sections
    Vec3 heart;
    Vec3 heartRadii;
    Rod vessels;
    Rod hila;
    Rod spine;
    double floor; ///< height of the lowest edge
};

const Form kRight{{46, -20.5, -102},
                  {36, 8.5, 55},
                  73,
                  79.5,
                  2.1,
                  {-22, -38.5, -56},
                  {55.5, 50.5, 63},
                  {-25.5, -7.5, 29.5, 13.5},
                  {12.5, 12.5, 18, 17},
                  {60, 60, 43, 31},
                  -177};
const Form kLeft{{65, -23, -102.5},
                 {41, 11.5, 59},
                 58.5,
                 77,
                 1.8,
                 {15.5, -47.5, -75.5},
                 {61, 50, 61},
                 {-39, -60, 42, 8},
                 {2, 2, 33, 32},
                 {60, 60, 16, 48},
                 -185};
/// The cardiac notch of the left lung.
const Vec3 kNotch{11, -81, -130.5};
const Vec3 kNotchRadii{38, 36, 34};

/// The space under the ribs: a section of rounded corners that narrows to the apex.
double underRibs(const Form& form, const Vec3& p)
{
    const double height = form.apex.z() - form.base.z();
    const double up = (p.z() - form.base.z()) / height;
    const double lean = std::max(up, 0.0);
    const double x = (p.x() - form.base.x() - lean * (form.apex.x() - form.base.x()));
    const double y = (p.y() - form.base.y() - lean * (form.apex.y() - form.base.y()));
    const double across = std::pow(std::abs(x) / form.halfWidth, form.corners)
                          + std::pow(std::abs(y) / form.halfDepth, form.corners);
    const double e = std::sqrt(std::pow(across, 2.0 / form.corners) + up * up);
    return (e - 1.0) * form.halfWidth;
}

/// The bodies of the thoracic vertebrae and, beside them, the tips of their transverse processes
/// with the necks of the ribs: a place on each line and the radius there.
struct Bone {
    double y, z, radius;
    double besideX, besideY;
};
constexpr std::array kColumn{Bone{7, 78, 18, 30, 22},      Bone{26, 11, 18, 32, 45},
                             Bone{33, -50, 19.5, 34, 55},  Bone{24, -116, 21, 31, 50},
                             Bone{10, -171, 22.5, 24, 39}, Bone{-4, -215, 23, 20, 28}};

double column(const Vec3& p)
{
    constexpr double kNeck = 7.0;
    double nearest = 1e3;
    for (std::size_t i = 0; i + 1 < kColumn.size(); ++i) {
        const Bone& a = kColumn[i];
        const Bone& b = kColumn[i + 1];
        nearest =
            std::min({nearest, rodDistance(p, {0.0, a.y, a.z}, {0.0, b.y, b.z}, a.radius, b.radius),
                      rodDistance(p, {a.besideX, a.besideY, a.z}, {b.besideX, b.besideY, b.z},
                                  kNeck, kNeck)});
    }
    return nearest;
}

/// Everything in the middle of the chest.
double mediastinum(const Form& form, const Vec3& p)
{
    const double heart = ellipsoidDistance(p - form.heart, form.heartRadii);
    const auto rod = [&p](const Rod& r, double lowerZ, double upperZ) {
        return rodDistance(p, {0.0, r.lowerY, lowerZ}, {0.0, r.upperY, upperZ}, r.lowerRadius,
                           r.upperRadius);
    };
    const double vessels = rod(form.vessels, -20.0, 120.0);
    const double hila = rod(form.hila, -70.0, 10.0);
    const double spine = rod(form.spine, -260.0, 140.0);
    return roundedMin(roundedMin(heart, vessels, 14.0), roundedMin(hila, spine, 14.0), 14.0);
}

double lungDistance(Side side, const Vec3& p)
{
    const double sign = side == Side::Right ? -1.0 : 1.0;
    const Form& form = side == Side::Right ? kRight : kLeft;
    constexpr double kFillet = 9.0;
    double d = underRibs(form, p);
    if (p.z() < kAboveDomes)
        d = roundedMax(d, kAboveDiaphragm - belowDiaphragm({sign * p.x(), p.y(), p.z()}), kFillet);
    d = roundedMax(d, -mediastinum(form, p), kFillet);
    d = roundedMax(d, -column(p), kFillet);
    d = roundedMax(d, 5.0 - p.x(), kFillet);
    d = roundedMax(d, form.floor - p.z(), kFillet);
    if (side == Side::Left) // the cardiac notch
        d = roundedMax(d, -ellipsoidDistance(p - kNotch, kNotchRadii), kFillet);
    return d;
}

/// How high above the oblique fissure: it comes down from the fifth vertebra at the back to the
/// sixth cartilage in front.
double aboveOblique(Side side, const Vec3& p)
{
    const double aside = side == Side::Right ? 0.05 : -0.19;
    return (p.z() - 0.73 * p.y() - aside * p.x()) / 1.24;
}

/// And above the horizontal one of the right lung, at the fourth cartilage.
double aboveHorizontal(const Vec3& p) { return p.z() - 0.14 * p.y(); }

struct Lung {
    Side side;
    double sign;
    Vec3 origin_A;
    double unit;
    Implicit outside;
    double oblique = 0.0; ///< where the fissures lie, in the units above
    double horizontal = 0.0;

    Lung(Side s, const BodyPlan& plan, const Implicit& outsideLungs)
        : side(s),
          sign(s == Side::Right ? -1.0 : 1.0),
          origin_A(plan.inChest(Vec3::Zero())),
          unit(plan.chest),
          outside(outsideLungs)
    {
    }

    [[nodiscard]] Vec3 local(const Vec3& p_A) const
    {
        const Vec3 p = (p_A - origin_A) / unit;
        return {sign * p.x(), p.y(), p.z()};
    }

    [[nodiscard]] double whole(const Vec3& p_A) const
    {
        return roundedMax(lungDistance(side, local(p_A)), kClearance - outside(p_A) / unit, 4.0);
    }

    [[nodiscard]] Box bounds() const
    {
        Box box;
        for (const Vec3& p : {Vec3{2.0, -125.0, -215.0}, Vec3{130.0, 70.0, 82.0}})
            box.include(origin_A + unit * Vec3{sign * p.x(), p.y(), p.z()});
        return box;
    }
};

/// Places inside a lung, evenly spread.
std::vector<Vec3> placesIn(const Lung& lung)
{
    constexpr double kStep = 5.0;
    const Box box = lung.bounds();
    std::vector<Vec3> places;
    const double step = kStep * lung.unit;
    for (double x = box.min.x(); x < box.max.x(); x += step)
        for (double y = box.min.y(); y < box.max.y(); y += step)
            for (double z = box.min.z(); z < box.max.z(); z += step)
                if (const Vec3 p_A{x, y, z}; lung.whole(p_A) < 0.0)
                    places.push_back(lung.local(p_A));
    return places;
}

/// Where a share of the heights lies below.
template <class Height> double quantile(std::vector<Vec3> places, double share, Height height)
{
    const auto at =
        places.begin()
        + std::ptrdiff_t(std::min(share * double(places.size()), double(places.size() - 1)));
    std::ranges::nth_element(places, at, {}, height);
    return height(*at);
}

/// Puts the fissures where the lobes have their shares.
void cut(Lung& lung, const LobeShares& shares)
{
    const bool right = lung.side == Side::Right;
    const double whole = right ? shares.rightUpper + shares.rightMiddle + shares.rightLower
                               : shares.leftUpper + shares.leftLower;
    const auto oblique = [&](const Vec3& p) { return aboveOblique(lung.side, p); };
    std::vector<Vec3> places = placesIn(lung);
    const double lower = (right ? shares.rightLower : shares.leftLower) / whole;
    lung.oblique = quantile(places, lower, oblique);
    if (right) {
        std::erase_if(places, [&](const Vec3& p) { return oblique(p) < lung.oblique; });
        lung.horizontal = quantile(
            places, shares.rightMiddle / (shares.rightMiddle + shares.rightUpper), aboveHorizontal);
    }
}

PartPlan lobe(const char* name, PartRole role, const char* concept_, const Lung& lung)
{
    const auto distance = [lung, role](const Vec3& p_A) {
        const Vec3 p = lung.local(p_A);
        const double oblique = aboveOblique(lung.side, p) - lung.oblique;
        const double horizontal = aboveHorizontal(p) - lung.horizontal;
        const bool lower = role == PartRole::RightLowerLobe || role == PartRole::LeftLowerLobe;
        double outside = lower ? oblique : -oblique;
        if (role == PartRole::RightMiddleLobe)
            outside = std::max(outside, horizontal);
        if (role == PartRole::RightUpperLobe)
            outside = std::max(outside, -horizontal);
        if (outside > kFarFromFissure) // whatever the lung is like there
            return lung.unit * outside;
        return lung.unit * roundedMax(lung.whole(p_A), outside + kHalfFissure, 5.0);
    };
    return {name, role, concept_, {lung.bounds(), distance}, 1e3 * lung.unit * kLungVoxel};
}

} // namespace

std::vector<PartPlan> lobes(const BodyPlan& plan, const Implicit& outsideLungs)
{
    Lung right{Side::Right, plan, outsideLungs};
    Lung left{Side::Left, plan, outsideLungs};
    cut(right, plan.dimensions.lobes);
    cut(left, plan.dimensions.lobes);
    return {lobe("Upper lobe of right lung", PartRole::RightUpperLobe, "FMA7333", right),
            lobe("Middle lobe of right lung", PartRole::RightMiddleLobe, "FMA7383", right),
            lobe("Lower lobe of right lung", PartRole::RightLowerLobe, "FMA7337", right),
            lobe("Upper lobe of left lung", PartRole::LeftUpperLobe, "FMA7370", left),
            lobe("Lower lobe of left lung", PartRole::LeftLowerLobe, "FMA7371", left)};
}

Vec3 hilum(Side side, const BodyPlan& plan)
{
    return plan.inChest(side == Side::Right ? Vec3{-26.0, 0.0, -22.0} : Vec3{43.0, 0.0, -36.0});
}

} // namespace carina
