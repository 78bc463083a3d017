#include "engine/lungs/volume_cubic.h"

#include "engine/lungs/displacement_mode.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)); }

/// The two turning points of the cubic, in order, moved to the nearest end of the range where they
/// lie outside it: between neighbours of (least, first, second, greatest) V only rises or falls.
std::array<double, 2> turningPoints(const VolumeCubic& cubic)
{
    // 3 c3 s^2 + 2 c2 s + c1 = 0 without the difference of two nearly equal numbers.
    const double discriminant = cubic.c[2] * cubic.c[2] - 3.0 * cubic.c[3] * cubic.c[1];
    const double q = -(cubic.c[2] + std::copysign(std::sqrt(discriminant), cubic.c[2]));
    std::array<double, 2> points{q / (3.0 * cubic.c[3]), cubic.c[1] / q};
    for (double& point : points) {
        point = std::isnan(point) ? kLeastAmplitude
                                  : std::clamp(point, kLeastAmplitude, kGreatestAmplitude);
    }
    std::ranges::sort(points);
    return points;
}

/// Where V takes `volume` between two amplitudes between which it only rises or falls, by
/// bisection down to neighbouring numbers.
std::optional<double> crossing(const VolumeCubic& cubic, Volume volume, double low, double high)
{
    const auto excess = [&](double s) { return cubic.at(s).si - volume.si; };
    if (excess(low) == 0.0)
        return low;
    if (excess(high) == 0.0)
        return high;
    const bool positiveAtLow = excess(low) > 0.0;
    if (positiveAtLow == (excess(high) > 0.0))
        return std::nullopt;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
            return middle;
        ((excess(middle) > 0.0) == positiveAtLow ? low : high) = middle;
    }
}

} // namespace

Volume VolumeCubic::at(double s) const
{
    return cubicMetres(c[0] + s * (c[1] + s * (c[2] + s * c[3])));
}

VolumeCubic& VolumeCubic::operator+=(const VolumeCubic& other)
{
    for (std::size_t k = 0; k < c.size(); ++k)
        c[k] += other.c[k];
    return *this;
}

VolumeCubic volumeCubic(const DeformableMesh& mesh)
{
    VolumeCubic cubic;
    if (mesh.rest.empty())
        return cubic;
    const Vec3 origin = mesh.rest.positions.front().cast<double>();
    std::array<Vec3, 3> x;
    std::array<Vec3, 3> d;
    for (const Triangle& triangle : mesh.rest.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            x[k] = mesh.rest.positions[triangle[k]].cast<double>() - origin;
            d[k] = mesh.displacement[triangle[k]].cast<double>();
        }
        cubic.c[0] += determinant(x[0], x[1], x[2]);
        cubic.c[1] += determinant(d[0], x[1], x[2]) + determinant(x[0], d[1], x[2])
                      + determinant(x[0], x[1], d[2]);
        cubic.c[2] += determinant(x[0], d[1], d[2]) + determinant(d[0], x[1], d[2])
                      + determinant(d[0], d[1], x[2]);
        cubic.c[3] += determinant(d[0], d[1], d[2]);
    }
    for (double& coefficient : cubic.c)
        coefficient /= 6.0;
    return cubic;
}

Result<double> amplitudeFor(const VolumeCubic& cubic, Volume volume, double nearest)
{
    if (!std::isfinite(volume.si) || !std::isfinite(nearest))
        return fail(Errc::NotFinite, "the volume asked of a lung is not a number");
    const auto [first, second] = turningPoints(cubic);
    const std::array ends{kLeastAmplitude, first, second, kGreatestAmplitude};
    std::optional<double> best;
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
        const auto s = crossing(cubic, volume, ends[piece], ends[piece + 1]);
        if (s && (!best || std::abs(*s - nearest) < std::abs(*best - nearest)))
            best = s;
    }
    if (!best)
        return fail(Errc::VolumeUnreachable, "the lung cannot be drawn with "
                                                 + std::to_string(inMillilitres(volume)) + " ml");
    return *best;
}

} // namespace carina
