#include "widgets/scene/labels/marker_shapes.h"

#include "engine/anatomy/shapes/swept_surface.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace carina
{
namespace
{

constexpr int kBallBands = 16;
constexpr double kTip = 0.02; ///< radius of a pointed end, of the largest radius

/// Rings along z, from a height on.
std::shared_ptr<const TriangleMesh> turned(double from, double until,
                                           const std::vector<Ring>& rings)
{
    const std::array ends{Vec3{0.0, 0.0, from}, Vec3{0.0, 0.0, until}};
    return std::make_shared<const TriangleMesh>(sweptSurface(sweptLine(ends), rings));
}

} // namespace

std::shared_ptr<const TriangleMesh> ballMarker(Length radius)
{
    const double r = radius.si;
    std::vector<Ring> rings;
    for (int i = 0; i <= kBallBands; ++i) {
        const double polar = std::numbers::pi * i / kBallBands;
        rings.push_back({r * (1.0 - std::cos(polar)), r * std::max(kTip, std::sin(polar))});
    }
    return turned(-r, r, rings);
}

std::shared_ptr<const TriangleMesh> diamondMarker(Length radius)
{
    const double r = radius.si;
    return turned(-r, r, {{0.0, kTip * r}, {r, r}, {2.0 * r, kTip * r}});
}

std::shared_ptr<const TriangleMesh> pointerMarker(Length length, Length radius)
{
    return turned(0.0, length.si, {{0.0, kTip * radius.si}, {length.si, radius.si}});
}

} // namespace carina
