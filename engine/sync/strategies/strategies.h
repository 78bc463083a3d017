#pragma once

#include "engine/sync/strategies/strategy.h"

namespace carina
{

/// The strategies; each source file describes its own. See also docs/synchronisation.md.
[[nodiscard]] SyncStrategy sessionClockStrategy();
[[nodiscard]] SyncStrategy localLagStrategy();
[[nodiscard]] SyncStrategy asaAdaptiveStrategy();
[[nodiscard]] SyncStrategy asaFixedStrategy();
[[nodiscard]] SyncStrategy deadReckoningStrategy();
[[nodiscard]] SyncStrategy interpolationStrategy();
[[nodiscard]] SyncStrategy eventStrategy();
[[nodiscard]] SyncStrategy noneStrategy();

} // namespace carina
