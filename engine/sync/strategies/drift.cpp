#include "engine/sync/strategies/drift.h"

#include "engine/geometry/rotation.h"

#include <algorithm>

namespace carina
{

Drift driftBetween(const RigidTransform& X_AO_sent, const RigidTransform& X_AO_shown)
{
    return {angleBetween(X_AO_sent.rotation(), X_AO_shown.rotation()),
            metres((X_AO_sent.translation() - X_AO_shown.translation()).norm())};
}

Drift driftBetween(const ActedPose& sent, const ActedPose& shown)
{
    Drift drift = driftBetween(sent.X_AO, shown.X_AO);
    const auto [smaller, larger] = std::minmax(sent.scale, shown.scale);
    drift.scale = larger / smaller - 1.0;
    return drift;
}

} // namespace carina
