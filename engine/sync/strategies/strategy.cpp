#include "engine/sync/strategies/strategy.h"

#include "engine/sync/strategies/strategies.h"

#include <algorithm>
#include <array>

namespace carina
{

std::span<const SyncStrategy> syncStrategies()
{
    static const std::array all{
        sessionClockStrategy(),  localLagStrategy(),      asaAdaptiveStrategy(), asaFixedStrategy(),
        deadReckoningStrategy(), interpolationStrategy(), eventStrategy(),       noneStrategy()};
    return all;
}

StarSeat starSeat(ParticipantId self, std::uint16_t participants)
{
    StarSeat seat{self, {}};
    for (std::uint16_t id = 1; id <= participants; ++id)
        if (ParticipantId{id} != self)
            seat.others.push_back(ParticipantId{id});
    return seat;
}

const SyncStrategy* findSyncStrategy(std::string_view name)
{
    const auto all = syncStrategies();
    const auto found = std::ranges::find(all, name, &SyncStrategy::name);
    return found == all.end() ? nullptr : &*found;
}

const SyncStrategy& syncStrategy(StrategyKind kind)
{
    return *std::ranges::find(syncStrategies(), kind, &SyncStrategy::kind);
}

} // namespace carina
