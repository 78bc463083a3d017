#pragma once

#include "engine/sync/strategies/strategy.h"

namespace carina
{

[[nodiscard]] SyncStrategy sessionClockStrategy();
[[nodiscard]] SyncStrategy asaAdaptiveStrategy();
[[nodiscard]] SyncStrategy asaFixedStrategy();
[[nodiscard]] SyncStrategy deadReckoningStrategy();
[[nodiscard]] SyncStrategy interpolationStrategy();
[[nodiscard]] SyncStrategy eventStrategy();
[[nodiscard]] SyncStrategy noneStrategy();

} // namespace carina
