#include "engine/sync/strategies/strategy.h"

#include "engine/sync/strategies/strategies.h"

#include <algorithm>
#include <array>

namespace carina
{

std::span<const SyncStrategy> syncStrategies()
{
    static const std::array all{
        sessionClockStrategy(),  asaAdaptiveStrategy(), asaFixedStrategy(), deadReckoningStrategy(),
        interpolationStrategy(), eventStrategy(),       noneStrategy()};
    return all;
}

const SyncStrategy* findSyncStrategy(std::string_view name)
{
    const auto all = syncStrategies();
    const auto found = std::ranges::find(all, name, &SyncStrategy::name);
    return found == all.end() ? nullptr : &*found;
}

} // namespace carina
