#include "engine/anatomy/larynx/vallecula_shape.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Written in the millimetres of LarynxFrame; of places, how far they are in front of the middle of
/// the epiglottis stands for y.
constexpr Length kValleculaVoxel = millimetres(0.9);
constexpr double kFloor = 14.8; ///< the tongue's is 0.8 above it (Tongue)
constexpr double kFloorThick = 2.8;
constexpr double kFloorFrom = -0.5;
constexpr double kFloorEnd = 12.0;
constexpr double kHalfFloor = 12.5;

double heightOfFloor(double x, double inFront)
{
    constexpr double kRise = 0.35; // towards the tongue, flatter than a blade lies
    constexpr double kRiseFrom = 4.0;
    constexpr double kBeside = 1.6; // over the laminae of the thyroid cartilage
    constexpr double kHollow = 1.7; // on each side of the median fold, below that of the tongue
    const double across = easedStep(1.5, 4.5, x) * easedStep(9.5, 6.5, x);
    const double along = easedStep(0.5, 3.0, inFront) * easedStep(9.0, 6.0, inFront);
    return kFloor + kRise * roundedMax(inFront - kRiseFrom, 0.0, 2.0)
           + kBeside * easedStep(4.0, 9.5, x) - kHollow * across * along;
}

/// It runs down the front of the epiglottis, below the tongue's part of that fold.
double footOfMedianFold(double x, double inFront, double z)
{
    constexpr double kHalfThick = 0.9;
    const double edge = 0.55 * (z - 20.5 + 1.5 * inFront);
    const double section = std::max({edge, kFloorFrom - inFront, kFloor - 1.0 - z});
    return roundedMax(section, x - kHalfThick, 0.8);
}

/// From the side of the epiglottis to the wall of the pharynx.
double lateralFold(const Vec3& p)
{
    return rodDistance(p, {9.0, -0.6, 18.8}, {12.0, -5.0, 16.4}, 1.3, 1.5);
}

double valleculaAt(const Vec3& p, const Epiglottis& epiglottis)
{
    const double x = std::abs(p.x());
    const double inFront = epiglottis.middleAt(p.z()) - p.y();
    const double half = 0.5 * kFloorThick;
    const double slab = 0.9 * (std::abs(p.z() - heightOfFloor(x, inFront) + half) - half);
    const double folds =
        std::min(footOfMedianFold(x, inFront, p.z()), 0.9 * lateralFold({x, -inFront, p.z()}));
    const double ends = std::max({kFloorFrom - inFront, inFront - kFloorEnd, x - kHalfFloor});
    return roundedMax(roundedMin(slab, folds, 1.2), 0.9 * ends, 1.0);
}

} // namespace

PartPlan vallecula(const LarynxFrame& frame, const Epiglottis& epiglottis)
{
    const double middle = epiglottis.middleAt(kFloor);
    const Box box{Vec3{-15.0, middle - 16.0, 9.0}, Vec3{15.0, middle + 6.0, 25.0}};
    return {
        "Vallecula", PartRole::LaryngealMucosa, "",
        frame.inAnatomy(box, [epiglottis](const Vec3& p) { return valleculaAt(p, epiglottis); }),
        1e3 * frame.unit() * kValleculaVoxel};
}

} // namespace carina
