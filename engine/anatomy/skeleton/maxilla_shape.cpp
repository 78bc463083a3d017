#include "engine/anatomy/skeleton/maxilla_shape.h"

#include "engine/anatomy/shapes/strand.h"
#include "engine/anatomy/skeleton/cranium_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kMaxillaVoxel = millimetres(2.1);

/// One half, in reference millimetres (BodyPlan) from the edge of the upper incisors.
double half(const Vec3& p)
{
    // The alveolar process follows the roots of the teeth as far as the tuberosity; it is open
    // above the palate and, in front, below the nose.
    static const auto arch = cornersCut({Vec2{-3.0, 6.8}, Vec2{4.0, 6.8}, Vec2{10.5, 9.0},
                                         Vec2{16.5, 12.5}, Vec2{19.8, 18.0}, Vec2{22.6, 24.3},
                                         Vec2{23.6, 33.0}, Vec2{23.4, 42.0}, Vec2{22.0, 51.0}},
                                        2);
    const AlongLine at = alongLine({p.x(), p.y()}, arch);
    // Its lower edge rises from the incisors to the tuberosity.
    const double low = 13.0 + 0.16 * at.along;
    const double high = 28.0 + 0.15 * at.along;
    const double ends = std::max({low - p.z(), p.z() - high, p.y() - 53.0});
    const double alveolar = roundedMax(at.off - 6.2, ends, 4.0);
    const double body = ellipsoidDistance(p - Vec3{26.0, 31.0, 40.0}, {13.5, 16.0, 18.0});
    const double zygomatic = rodDistance(p, {33.0, 30.0, 37.0}, {42.0, 33.0, 34.0}, 8.0, 5.0);
    const double frontal = std::min(rodDistance(p, {16.5, 10.0, 34.0}, {8.5, 5.0, 56.0}, 5.0, 3.8),
                                    rodDistance(p, {8.5, 5.0, 56.0}, {8.0, 8.0, 66.0}, 3.8, 3.4));
    const double spine = rodDistance(p, {0.0, 4.0, 27.0}, {0.0, -0.5, 29.5}, 3.2, 1.6);
    const double outer = roundedMin(body, zygomatic, 6.0);
    const double bone = roundedMin(roundedMin(alveolar, outer, 8.0), frontal, 6.0);
    // Its body is the floor of the orbit, and reaches the zygomatic bone.
    return roundedMax(roundedMin(bone, spine, 4.0), -orbitDistance(p), 3.0);
}

} // namespace

double maxillaDistance(const Vec3& p_mm)
{
    return 0.9 * half({std::abs(p_mm.x()), p_mm.y(), p_mm.z()});
}

PartPlan maxilla(const BodyPlan& plan)
{
    const Box bounds{plan.inFace({-52.0, -8.0, 8.0}), plan.inFace({52.0, 60.0, 76.0})};
    const Vec3 origin = plan.inFace(Vec3::Zero());
    const auto distance = [origin, unit = plan.face](const Vec3& p_A) {
        return unit * maxillaDistance((p_A - origin) / unit);
    };
    return {
        "Maxilla", PartRole::Skull, "FMA9711", {bounds, distance}, 1e3 * plan.face * kMaxillaVoxel};
}

} // namespace carina
