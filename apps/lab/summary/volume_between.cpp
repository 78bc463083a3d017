#include "apps/lab/summary/volume_between.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr Duration kLongestGapBetween = std::chrono::milliseconds{200};
constexpr std::ptrdiff_t kPoints = 4; ///< of the cubic, half of them on either side

struct DrawnVolume {
    Duration at;
    double volume_ml;
};

std::vector<DrawnVolume> volumesOf(std::span<const LoggedFrame> frames, Sameness same)
{
    std::vector<DrawnVolume> volumes;
    for (const LoggedFrame& frame : frames) {
        const Duration at = same == Sameness::Instant ? frame.local.time_since_epoch()
                                                      : frame.session.time_since_epoch();
        if (volumes.empty() || at > volumes.back().at)
            volumes.push_back({at, frame.volume_ml[0] + frame.volume_ml[1]});
    }
    return volumes;
}

/// Lagrange's polynomial through the points, at a time.
double polynomialAt(std::span<const DrawnVolume> points, Duration at)
{
    double sum = 0.0;
    for (const DrawnVolume& point : points) {
        double weight = 1.0;
        for (const DrawnVolume& other : points)
            if (other.at != point.at)
                weight *= toSeconds(at - other.at) / toSeconds(point.at - other.at);
        sum += weight * point.volume_ml;
    }
    return sum;
}

/// Nothing where the owner was not drawing all around that time.
std::optional<double> volumeAt(std::span<const DrawnVolume> owner, Duration at)
{
    const auto after = std::ranges::upper_bound(owner, at, {}, &DrawnVolume::at);
    if (after - owner.begin() < kPoints / 2 || owner.end() - after < kPoints / 2)
        return std::nullopt;
    const std::span<const DrawnVolume> points{after - kPoints / 2, kPoints};
    const auto isFar = [](const DrawnVolume& a, const DrawnVolume& b) {
        return b.at - a.at > kLongestGapBetween;
    };
    if (std::ranges::adjacent_find(points, isFar) != points.end())
        return std::nullopt;
    return polynomialAt(points, at);
}

} // namespace

VolumeDifference volumesBetween(std::span<const LoggedFrame> owner,
                                std::span<const LoggedFrame> viewer, Sameness same)
{
    const std::vector<DrawnVolume> owned = volumesOf(owner, same);
    std::vector<double> apart_ml;
    for (const DrawnVolume& seen : volumesOf(viewer, same))
        if (const auto volume_ml = volumeAt(owned, seen.at))
            apart_ml.push_back(std::abs(seen.volume_ml - *volume_ml));
    if (apart_ml.empty())
        return {};
    std::ranges::sort(apart_ml);
    const std::size_t rank = (apart_ml.size() * 95 + 99) / 100 - 1; // nearest-rank percentile
    return {.instants = static_cast<int>(apart_ml.size()),
            .mean_ml = std::accumulate(apart_ml.begin(), apart_ml.end(), 0.0)
                       / static_cast<double>(apart_ml.size()),
            .p95_ml = apart_ml[rank],
            .largest_ml = apart_ml.back()};
}

} // namespace carina::lab
