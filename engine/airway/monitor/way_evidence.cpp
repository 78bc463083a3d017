#include "engine/airway/monitor/way_evidence.h"

#include <algorithm>

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

} // namespace

void WayEvidence::take(Length depth, Length beyond, Length apart)
{
    AtDepth& there = depths[placeOf(depth)];
    const double weight = there.isSeen ? kNewest : 1.0;
    there.beyond += weight * (beyond.si - there.beyond);
    there.apart += weight * (apart.si - there.apart);
    there.isSeen = true;
}

double WayEvidence::logOdds(Length registration, Length shape) const
{
    double weights = 0.0;
    double squares = 0.0;
    double beyond = 0.0;
    double inLumen = 0.0;
    for (const AtDepth& there : depths) {
        if (!there.isSeen)
            continue;
        const double square = there.apart * there.apart;
        weights += there.apart;
        squares += square;
        beyond += there.apart * there.beyond;
        inLumen += square * kInLumen * kInLumen * square;
    }
    if (!(weights > 0.0))
        return 0.0;
    const double variance =
        registration.si * registration.si + shape.si * shape.si + inLumen / (weights * weights);
    return squares / weights * (beyond / weights) / variance;
}

} // namespace carina
