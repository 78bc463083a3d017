#include "engine/anatomy/airway/airway_path.h"

#include "engine/core/expects.h"

#include <array>
#include <cmath>

namespace carina
{

namespace
{

constexpr Length kPathSpacing = millimetres(2.0);

/// Out of the mouth: forward and 20 degrees down.
Vec3 outOfMouth()
{
    const double down = degrees(20.0).si;
    return {0.0, -std::cos(down), -std::sin(down)};
}

/// From the incisors back over the tongue and down to the glottis: a cubic Bezier curve that leaves
/// the teeth along the mouth and arrives along the trachea.
Centreline overTheTongue(const Vec3& p_A_incisors, const Vec3& p_A_glottis, const Vec3& up)
{
    const double chord = (p_A_incisors - p_A_glottis).norm();
    const std::array<Vec3, 4> c{p_A_incisors, p_A_incisors - 0.60 * chord * outOfMouth(),
                                p_A_glottis + 0.55 * chord * up, p_A_glottis};
    constexpr int kPieces = 256;
    Centreline curve;
    for (int i = 0; i <= kPieces; ++i) {
        const double t = double(i) / kPieces;
        const double u = 1.0 - t;
        curve.push_back(u * u * u * c[0] + 3.0 * u * u * t * c[1] + 3.0 * u * t * t * c[2]
                        + t * t * t * c[3]);
    }
    return curve;
}

Vec3 upAtGlottis(std::span<const Vec3> down)
{
    CARINA_EXPECTS(down.size() >= 2);
    return (down[0] - pointAlong(down, millimetres(15.0))).normalized();
}

} // namespace

Centreline airwayPath(const Vec3& p_A_incisors, std::span<const Vec3> down)
{
    const Vec3 start = p_A_incisors + kPathInFrontOfTeeth.si * outOfMouth();
    Centreline path = evenlySpaced(std::array{start, p_A_incisors}, kPathSpacing);
    const Centreline curve =
        evenlySpaced(overTheTongue(p_A_incisors, down[0], upAtGlottis(down)), kPathSpacing);
    const Centreline trachea = evenlySpaced(down, kPathSpacing);
    path.insert(path.end(), curve.begin() + 1, curve.end());
    path.insert(path.end(), trachea.begin() + 1, trachea.end());
    return path;
}

Vec3 incisorsAtLength(std::span<const Vec3> down, Length incisorsToGlottis, Angle rise)
{
    // The curve grows with its chord, so one length tells every other.
    const Vec3 forwardAndUp{0.0, -std::cos(rise.si), std::sin(rise.si)};
    const Centreline unit = overTheTongue(down[0] + forwardAndUp, down[0], upAtGlottis(down));
    return down[0] + incisorsToGlottis.si / lengthOf(unit).si * forwardAndUp;
}

} // namespace carina
