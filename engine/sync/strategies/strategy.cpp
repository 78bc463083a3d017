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

std::vector<ParticipantId> starParticipants(std::uint16_t number)
{
    std::vector<ParticipantId> ids;
    for (std::uint16_t id = 1; id <= number; ++id)
        ids.push_back(ParticipantId{id});
    return ids;
}

StarSeat starSeat(ParticipantId self, std::uint16_t participants)
{
    StarSeat seat{self, starParticipants(participants)};
    std::erase(seat.others, self);
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
