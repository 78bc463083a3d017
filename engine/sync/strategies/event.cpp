#include "engine/sync/strategies/relay_host.h"
#include "engine/sync/strategies/relayed_participant.h"
#include "engine/sync/strategies/strategies.h"

namespace carina
{
namespace
{

/// Event updates: each action brings the object's absolute pose, and goes on from there from the
/// moment it arrives. All views of others are late by the delay.
class EventParticipant final : public RelayedParticipant
{
public:
    using RelayedParticipant::RelayedParticipant;

private:
    void actionReceived(const EventCpo& action, ParticipantId, LocalTime now) override
    {
        drawn().begin(action, now);
    }
};

} // namespace

SyncStrategy eventStrategy()
{
    return {StrategyKind::Event, "event",
            "each action brings the absolute pose and begins when it arrives", RelayHost::make,
            [](const StarSeat& seat, const StrategyChoice&,
               LocalTime) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<EventParticipant>(seat.self);
            }};
}

} // namespace carina
