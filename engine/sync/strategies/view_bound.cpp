#include "engine/sync/strategies/view_bound.h"

#include <algorithm>

namespace carina
{
namespace
{

/// The errors of the angle are 0.2 degrees each, root mean square, for markers with 0.1 to 0.3 mm
/// on a ball of 45 mm; this is more than three times their difference. A distance is measured far
/// better than it is seen.
constexpr Drift kTwoSamples{degrees(1.0), millimetres(1.0)};

} // namespace

Drift trackedViewBound(const Drift& limit, Duration delay)
{
    const double t = toSeconds(delay + kSampleAge);
    const double gained = t * t / 2.0;
    return {kTwoSamples.rotation + std::max(limit.rotation, gained * kHandAcceleration.rotation),
            kTwoSamples.position + std::max(limit.position, gained * kHandAcceleration.position)};
}

} // namespace carina
