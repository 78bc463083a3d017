#include "engine/sync/strategies/relay_host.h"
#include "engine/sync/strategies/relayed_participant.h"
#include "engine/sync/strategies/strategies.h"
#include "engine/sync/streams/stream_tick.h"

#include <map>

namespace carina
{
namespace
{

/// Snapshot interpolation: the owner sends the poses of its objects 60 times a second, and all
/// others draw them late by a buffer that adapts, between the two snapshots around that time.
class InterpolationParticipant final : public RelayedParticipant
{
public:
    using RelayedParticipant::RelayedParticipant;

    void act(const EventCpo& action, LocalTime now) override
    {
        if (m_own.empty())
            m_tick.served(now);
        drawn().begin(action, now);
        m_own[action.object] = action;
    }

    void advance(LocalTime now) override
    {
        if (m_own.empty() || !m_tick.isDue(now))
            return;
        m_tick.served(now);
        for (const auto& [object, action] : m_own) {
            EventCpo snapshot = begunFrom(*drawn().at(object, now), ownStamp(now), action);
            snapshot.rate = 0.0F;
            sendRelayed(kAllOthers, snapshot);
        }
    }

    [[nodiscard]] LocalTime nextWake() const override
    {
        return m_own.empty() ? LocalTime::max() : m_tick.next();
    }

    void forget(ObjectId object) override
    {
        RelayedParticipant::forget(object);
        m_own.erase(object);
    }

private:
    void actionReceived(const EventCpo& snapshot, ParticipantId, LocalTime now) override
    {
        drawn().addSnapshot(snapshot, now);
    }

    StreamTick m_tick;
    std::map<ObjectId, EventCpo> m_own;
};

} // namespace

SyncStrategy interpolationStrategy()
{
    return {StrategyKind::Interpolation, "interpolation",
            "60 snapshots a second, drawn late by an adaptive buffer", RelayHost::make,
            [](const StarSeat& seat, const StrategyChoice&,
               LocalTime) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<InterpolationParticipant>(seat.self);
            }};
}

} // namespace carina
