#include "engine/anatomy/skeleton/mandible_shape.h"

#include <algorithm>
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
    return cornersCut({Vec2{0.0, 7.5}, Vec2{8.0, 8.5}, Vec2{15.0, 11.5}, Vec2{20.0, 16.0},
                       Vec2{25.5, 23.0}, Vec2{31.0, 30.0}, Vec2{39.0, 38.0}, Vec2{41.5, 50.0},
                       Vec2{43.0, 62.0}, Vec2{46.0, 74.0}, Vec2{48.0, 84.0}, Vec2{49.0, 90.0}},
                      2);
}

/// The same half rolled out: along the plan, and up.
std::array<Vec2, 24> jawOutline()
{
    return {Vec2{-9.0, -6.0},  Vec2{39.0, -3.5},  Vec2{47.0, 2.0},   Vec2{49.0, 20.0},
            Vec2{51.0, 38.0},  Vec2{55.0, 43.0},  Vec2{60.0, 40.0},  Vec2{65.0, 35.0},
            Vec2{72.0, 34.0},  Vec2{81.0, 38.0},  Vec2{87.0, 47.0},  Vec2{93.0, 52.0},
            Vec2{100.0, 51.0}, Vec2{102.0, 44.0}, Vec2{98.0, 20.0},  Vec2{95.0, 2.0},
            Vec2{91.0, -3.0},  Vec2{81.0, -8.0},  Vec2{71.0, -13.0}, Vec2{61.0, -19.0},
            Vec2{51.0, -24.0}, Vec2{39.0, -29.0}, Vec2{25.0, -32.0}, Vec2{-9.0, -31.0}};
}

/// How much nearer to the midline a place of the ramus is than the plan, which is that of the
/// condyles: from there it leans inward on its way down to the angle. By how much is of ours; it
/// gives a man and a woman the distance between their angles, 95.17 (6.45) and 86.84 (4.81) mm
/// (cone-beam CT of 99, Mandibular sexual dimorphism in a Syrian sample, 2020).
double leanOfRamus(const Vec3& p)
{
    constexpr double kLean = 0.075;
    constexpr double kCondyles = 47.0;
    return kLean * std::max(0.0, kCondyles - p.z()) * easedStep(34.0, 60.0, p.y());
}

double jaw(const Vec3& p)
{
    static const auto plan = jawPlan();
    static const auto outline = jawOutline();
    const AlongLine at = alongLine({std::abs(p.x()) + leanOfRamus(p), p.y()}, plan);
    // The body is thick, the ramus a plate that thickens again towards the condyle.
    const double half = 5.6 - 2.0 * easedStep(43.0, 55.0, at.along)
                        + 2.6 * easedStep(28.0, 40.0, p.z()) * easedStep(81.0, 89.0, at.along);
    const double bone = roundedMax(at.off - half, polygonDistance({at.along, p.z()}, outline), 7.0);
    const double chin = ellipsoidDistance(p - Vec3{0.0, 5.5, -27.0}, {14.0, 5.5, 6.5});
    const double condyle = ellipsoidDistance(
        Vec3{std::abs(p.x()) - 48.0, p.y() - 82.0, p.z() - 47.0}, {9.5, 5.0, 5.0});
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
