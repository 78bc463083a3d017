#include "engine/lungs/drawing/volume_cubic.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

/// The two turning points of the cubic, in order, moved to the nearest end of the range where they
/// lie outside it: between neighbours of (least, first, second, greatest) V only rises or falls.
std::array<double, 2> turningPoints(const VolumeCubic& cubic, const AmplitudeRange& range)
{
    // 3 c3 s^2 + 2 c2 s + c1 = 0 without the difference of two nearly equal numbers.
    const double discriminant = cubic.c[2] * cubic.c[2] - 3.0 * cubic.c[3] * cubic.c[1];
    const double q = -(cubic.c[2] + std::copysign(std::sqrt(discriminant), cubic.c[2]));
    std::array<double, 2> points{q / (3.0 * cubic.c[3]), cubic.c[1] / q};
    for (double& point : points) {
        point = std::isnan(point) ? range.least : std::clamp(point, range.least, range.greatest);
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

Result<double> amplitudeFor(const VolumeCubic& cubic, Volume volume, double nearest,
                            const AmplitudeRange& range)
{
    CARINA_EXPECTS(std::isfinite(range.least) && std::isfinite(range.greatest)
                   && range.least <= range.greatest);
    if (!std::isfinite(volume.si) || !std::isfinite(nearest))
        return fail(Errc::NotFinite, "the volume asked of a lung is not a number");
    const auto [first, second] = turningPoints(cubic, range);
    const std::array ends{range.least, first, second, range.greatest};
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
