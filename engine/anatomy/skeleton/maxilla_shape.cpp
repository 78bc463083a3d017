#include "engine/anatomy/skeleton/maxilla_shape.h"

#include "engine/anatomy/shapes/strand.h"
#include "engine/anatomy/skeleton/cranium_shape.h"

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
    // The alveolar process follows the roots of the teeth; it is open above the palate.
    static const auto arch = cornersCut({Vec2{-3.0, 6.8}, Vec2{4.0, 6.8}, Vec2{10.5, 9.0},
                                         Vec2{16.5, 12.5}, Vec2{19.8, 18.0}, Vec2{22.6, 24.3},
                                         Vec2{23.6, 33.0}, Vec2{23.4, 42.0}, Vec2{22.0, 51.0}},
                                        2);
    const AlongLine at = alongLine({p.x(), p.y()}, arch);
    // Its lower edge rises from the incisors to the tuberosity.
    const double low = 13.0 + 0.16 * at.along;
    const double alveolar = roundedMax(at.off - 6.2, std::max(low - p.z(), p.z() - 35.0), 4.0);
    const double body = ellipsoidDistance(p - Vec3{24.0, 27.0, 43.0}, {13.5, 17.0, 17.0});
    const double frontal = rodDistance(p, {17.0, 9.0, 34.0}, {8.0, 5.0, 66.0}, 5.5, 3.5);
    const double spine = rodDistance(p, {0.0, 4.0, 27.0}, {0.0, -0.5, 29.5}, 3.2, 1.6);
    const double bone = roundedMin(roundedMin(alveolar, body, 8.0), frontal, 6.0);
    // Its body is the floor of the orbit.
    return roundedMax(roundedMin(bone, spine, 4.0), -orbitDistance(p), 3.0);
}

} // namespace

double maxillaDistance(const Vec3& p_mm)
{
    return 0.9 * half({std::abs(p_mm.x()), p_mm.y(), p_mm.z()});
}

PartPlan maxilla(const BodyPlan& plan)
{
    const Box bounds{plan.inFace({-40.0, -8.0, 8.0}), plan.inFace({40.0, 60.0, 72.0})};
    const Vec3 origin = plan.inFace(Vec3::Zero());
    const auto distance = [origin, unit = plan.face](const Vec3& p_A) {
        return unit * maxillaDistance((p_A - origin) / unit);
    };
    return {
        "Maxilla", PartRole::Skull, "FMA9711", {bounds, distance}, 1e3 * plan.face * kMaxillaVoxel};
}

} // namespace carina
