#include "engine/sync/strategies/drift.h"

#include "engine/geometry/rotation.h"

namespace carina
{

Drift driftBetween(const RigidTransform& X_AO_sent, const RigidTransform& X_AO_shown)
{
    return {angleBetween(X_AO_sent.rotation(), X_AO_shown.rotation()),
            metres((X_AO_sent.translation() - X_AO_shown.translation()).norm())};
}

} // namespace carina
