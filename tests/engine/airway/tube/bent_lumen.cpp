#include "tests/engine/airway/tube/bent_lumen.h"

#include "tests/engine/airway/lumen/still_lumen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina::test
{
namespace
{

constexpr double kQuarter = 0.5 * std::numbers::pi;
constexpr double kStraight = 0.02; ///< metres of a tube beside its connector
constexpr double kRestRadius = 0.14;

/// In E, at a length of a tube at rest.
Vec3 placeAtRest(double along)
{
    const double straight = std::min(along, kStraight);
    const double angle = (along - straight) / kRestRadius;
    return {0.0, -kRestRadius * (1.0 - std::cos(angle)), -straight - kRestRadius * std::sin(angle)};
}

Vec3 middleAt(const BentLumen& it, double along)
{
    if (along <= it.mouth || it.bend == 0.0)
        return {0.0, along, 0.0};
    const double angle = (along - it.mouth) / it.bend;
    if (angle < kQuarter)
        return {0.0, it.mouth + it.bend * std::sin(angle), -it.bend * (1.0 - std::cos(angle))};
    return {0.0, it.mouth + it.bend, -it.bend - (along - it.mouth - kQuarter * it.bend)};
}

} // namespace

double BentLumen::length() const { return mouth + kQuarter * bend + below; }

double BentLumen::fromMiddle(const Vec3& p_A) const
{
    const double straight = std::hypot(p_A.x(), p_A.z());
    if (p_A.y() < mouth || bend == 0.0)
        return straight;
    if (p_A.z() < -bend)
        return std::hypot(p_A.x(), p_A.y() - mouth - bend);
    const double fromAxis = std::hypot(p_A.y() - mouth, p_A.z() + bend);
    return std::hypot(p_A.x(), fromAxis - bend);
}

AirwayLumen BentLumen::lumenFor(Length tubeRadius) const
{
    std::array<std::vector<Vec3>, kAirwayWays> lines;
    std::array<std::vector<double>, kAirwayWays> radii;
    std::size_t teeth = 0;
    std::size_t glottis = 0;
    for (double along = -kFunnel; along <= length() + 1e-9; along += kStep) {
        lines.front().push_back(middleAt(*this, along));
        const double before = std::min(along, 0.0);
        radii.front().push_back(radius + 0.5 * before * before / 0.015);
        if (along < 0.5 * kStep)
            teeth = lines.front().size() - 1;
        if (along < mouth + kQuarter * bend + 0.02)
            glottis = lines.front().size() - 1;
    }
    AirwayLumen lumen = roundLumen(lines, radii, tubeRadius);
    lumen.teeth = teeth;
    lumen.glottis = glottis;
    return lumen;
}

std::vector<Vec3> restCurve(const TubeSize& size)
{
    constexpr int kPieces = 200;
    std::vector<Vec3> curve;
    for (int i = 0; i <= kPieces; ++i)
        curve.push_back(placeAtRest(size.length.si * i / kPieces));
    return curve;
}

RigidTransform fed(const TubeSize& size, double inside)
{
    const double outside = size.length.si - inside;
    const double angle = std::max(outside - kStraight, 0.0) / kRestRadius;
    const double rise = std::clamp(0.5 * inside / kRestRadius, 0.0, 0.35);
    Mat3 R; // E of a connector that points straight into the mouth
    R << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    const Quat q = Quat{R} * Quat{Eigen::AngleAxisd{angle + rise, Vec3::UnitX()}};
    return {q, -(q * placeAtRest(outside))};
}

} // namespace carina::test
