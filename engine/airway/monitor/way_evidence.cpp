#include "engine/airway/monitor/way_evidence.h"

#include <algorithm>
#include <optional>

namespace carina
{
namespace
{

constexpr double kNewest = 0.2; // its weight among the samples at one depth

std::size_t placeOf(Length depth)
{
    const double place = std::max(depth / WayEvidence::kEach, 0.0);
    return std::min(static_cast<std::size_t>(place), WayEvidence::kDepths - 1);
}

/// Over the depths, by their weights; metres.
struct EvidenceMeans {
    double apart = 0.0;
    double beyond = 0.0;
    double shape = 0.0;
    double inLumen = 0.0; ///< standard deviation of `beyond` by the lumens, squared
};

std::optional<EvidenceMeans> meansOf(const WayEvidence& evidence, Length registration)
{
    constexpr double kSquare = WayEvidence::kInLumen * WayEvidence::kInLumen;
    EvidenceMeans sums;
    double weights = 0.0;
    double widths = 0.0;
    double doubts = 0.0;
    for (const WayEvidence::AtDepth& there : evidence.depths) {
        if (!there.isSeen || !(there.apart > 0.0))
            continue;
        widths += there.apart;
        doubts += there.apart * there.shape;
        const double shape = std::max(there.shape, doubts / widths);
        const double byLumen = kSquare * there.apart * there.apart;
        const double known = registration.si * registration.si + byLumen;
        const double weight = there.apart * (known / (known + shape * shape));
        weights += weight;
        sums.apart += weight * there.apart;
        sums.beyond += weight * there.beyond;
        sums.shape += weight * shape;
        sums.inLumen += weight * weight * byLumen;
    }
    if (!(weights > 0.0))
        return std::nullopt;
    return EvidenceMeans{sums.apart / weights, sums.beyond / weights, sums.shape / weights,
                         sums.inLumen / (weights * weights)};
}

} // namespace

void WayEvidence::take(Length depth, Length beyond, Length apart, Length shape)
{
    AtDepth& there = depths[placeOf(depth)];
    const double weight = there.isSeen ? kNewest : 1.0;
    there.beyond += weight * (beyond.si - there.beyond);
    there.apart += weight * (apart.si - there.apart);
    there.shape += weight * (shape.si - there.shape);
    there.isSeen = true;
}

double WayEvidence::logOdds(Length registration) const
{
    const auto means = meansOf(*this, registration);
    if (!means)
        return 0.0;
    const double variance =
        registration.si * registration.si + means->shape * means->shape + means->inLumen;
    return means->apart * means->beyond / variance;
}

bool WayEvidence::isBent(Length registration) const
{
    const auto means = meansOf(*this, registration);
    return means && means->shape > registration.si;
}

} // namespace carina
