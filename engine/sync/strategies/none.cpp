#include "engine/sync/strategies/relay_host.h"
#include "engine/sync/strategies/relayed_participant.h"
#include "engine/sync/strategies/strategies.h"

namespace carina
{
namespace
{

/// No synchronisation: an action is a motion without a start pose. It starts from the pose that the
/// object has at this participant, so that the error of each action remains permanently.
class UnsynchronisedParticipant final : public RelayedParticipant
{
public:
    using RelayedParticipant::RelayedParticipant;

private:
    void actionReceived(const EventCpo& action, ParticipantId, LocalTime now) override
    {
        const auto acted = drawn().at(action.object, now);
        drawn().begin(acted ? begunFrom(*acted, action.start, action) : action, now);
    }
};

} // namespace

SyncStrategy noneStrategy()
{
    return {StrategyKind::None, "none",
            "each action moves the object from wherever it is, nothing is corrected",
            RelayHost::make,
            [](const StarSeat& seat, const StrategyChoice&,
               LocalTime) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<UnsynchronisedParticipant>(seat.self);
            }};
}

} // namespace carina
