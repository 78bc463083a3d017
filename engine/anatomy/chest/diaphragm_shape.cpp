#include "engine/anatomy/chest/diaphragm_shape.h"

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

constexpr Length kDiaphragmVoxel = millimetres(4.6);
constexpr double kHalfSheet = 2.6;

struct Dome {
    Vec3 middle;
    Vec3 radii;
};

const Dome kRightDome{{-47.5, -52.5, -185.5}, {74.0, 90.0, 90.0}};
const Dome kLeftDome{{44.0, -46.0, -186.5}, {76.0, 86.0, 78.5}};

/// x to the power of 5/2, and back.
double raised(double x) { return x * x * std::sqrt(x); }
double lowered(double x) { return std::pow(x, 0.4); }

/// An upright body whose level sections have rounded corners and whose top is a flat dome.
double dome(const Dome& d, const Vec3& p)
{
    const Vec3 q = (p - d.middle).cwiseQuotient(d.radii).cwiseAbs();
    const double up = p.z() > d.middle.z() ? q.z() : 0.0;
    return (lowered(raised(q.x()) + raised(q.y()) + raised(up)) - 1.0) * d.radii.x();
}

/// The wall of the chest and belly that the muscle lies against, as one upright tube.
double wallDistance(const Vec3& p)
{
    constexpr double kWide = 115.0;
    constexpr double kDeep = 76.0;
    const double x = std::abs(p.x() - 2.0) / kWide;
    const double y = std::abs(p.y() + 37.0) / kDeep;
    return (lowered(raised(x) + raised(y)) - 1.0) * kDeep;
}

/// The spine, in front of which the crura run down.
double spineDistance(const Vec3& p)
{
    return std::min(rodDistance(p, {0, 18, -143}, {0, 2, -200}, 24.0, 25.0),
                    rodDistance(p, {0, 2, -200}, {0, -10, -320}, 25.0, 26.0));
}

/// How high its lower edge is: in front of the midline at the xiphoid, lowest at the sides.
double lowerEdge(const Vec3& p)
{
    return std::max(-133.0 - 0.9 * std::abs(p.x()) - 0.75 * (p.y() + 115.0), -268.0);
}

} // namespace

double belowDiaphragm(const Vec3& p)
{
    return roundedMin(dome(kRightDome, p), dome(kLeftDome, p), 24.0);
}

PartPlan diaphragm(const BodyPlan& plan)
{
    const auto distance = [origin = plan.inChest(Vec3::Zero()),
                           unit = plan.chest](const Vec3& p_A) {
        const Vec3 p = (p_A - origin) / unit;
        const double inside = roundedMax(belowDiaphragm(p), wallDistance(p), 20.0);
        const double sheet = std::abs(roundedMax(inside, -spineDistance(p), 8.0)) - kHalfSheet;
        return unit * 0.8 * roundedMax(sheet, 0.6 * (lowerEdge(p) - p.z()), 2.0);
    };
    const Box bounds{plan.inChest({-126, -126, -300}), plan.inChest({126, 50, -80})};
    return {"Diaphragm",
            PartRole::Diaphragm,
            "FMA13295",
            {bounds, distance},
            1e3 * plan.chest * kDiaphragmVoxel};
}

} // namespace carina
