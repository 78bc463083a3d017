#include "engine/anatomy/mandible_shape.h"

#include <array>
#include <cmath>

namespace carina
{

namespace
{

/// The jaw is written in millimetres of the adult, from the edge of the lower incisors; both halves
/// are one half mirrored.

/// One half seen from above, from the chin to behind the condyle.
std::vector<Vec2> jawPlan()
{
    return cornersCut({Vec2{0.0, 1.0}, Vec2{8.0, 1.8}, Vec2{16.0, 5.5}, Vec2{22.5, 12.5},
                       Vec2{28.0, 22.0}, Vec2{33.0, 34.0}, Vec2{37.5, 47.0}, Vec2{41.5, 60.0},
                       Vec2{45.0, 72.0}, Vec2{48.0, 84.0}, Vec2{50.0, 94.0}},
                      2);
}

/// The same half rolled out: along the plan, and up.
std::array<Vec2, 19> jawOutline()
{
    return {Vec2{-9.0, -6.0},  Vec2{62.0, -5.0},  Vec2{69.0, 2.0},    Vec2{73.0, 16.0},
            Vec2{75.0, 34.0},  Vec2{77.5, 39.0},  Vec2{80.5, 36.0},   Vec2{84.0, 25.0},
            Vec2{89.0, 23.0},  Vec2{93.5, 29.0},  Vec2{96.0, 42.0},   Vec2{101.0, 45.0},
            Vec2{105.0, 41.0}, Vec2{103.0, 26.0}, Vec2{100.0, -10.0}, Vec2{96.0, -27.0},
            Vec2{86.0, -34.0}, Vec2{50.0, -36.0}, Vec2{-9.0, -38.0}};
}

double jaw(const Vec3& p)
{
    static const auto plan = jawPlan();
    static const auto outline = jawOutline();
    const AlongLine at = alongLine({std::abs(p.x()), p.y()}, plan);
    // The body is thick, the ramus a plate that thickens again towards the condyle.
    const double half = 5.6 - 2.0 * easedStep(58.0, 72.0, at.along)
                        + 2.6 * easedStep(28.0, 40.0, p.z()) * easedStep(86.0, 94.0, at.along);
    const double bone = roundedMax(at.off - half, polygonDistance({at.along, p.z()}, outline), 7.0);
    const double chin = ellipsoidDistance(p - Vec3{0.0, -1.0, -31.0}, {15.0, 5.0, 7.0});
    const double condyle = ellipsoidDistance(
        Vec3{std::abs(p.x()) - 48.0, p.y() - 83.0, p.z() - 41.0}, {10.0, 5.0, 4.5});
    return roundedMin(roundedMin(bone, chin, 8.0), condyle, 6.0);
}

} // namespace

ImplicitShape mandibleShape(const Vec3& p_A_lowerIncisors, double size)
{
    const double unit = 1e-3 * size;
    Box bounds;
    bounds.include(p_A_lowerIncisors + unit * Vec3{-64.0, -14.0, -46.0});
    bounds.include(p_A_lowerIncisors + unit * Vec3{64.0, 104.0, 54.0});
    const auto distance = [p_A_lowerIncisors, unit](const Vec3& p_A) {
        return unit * jaw((p_A - p_A_lowerIncisors) / unit);
    };
    return {bounds, distance};
}

} // namespace carina
