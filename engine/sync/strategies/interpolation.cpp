#include "engine/sync/strategies/playout_buffer.h"
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
        running().begin(action, now);
        m_own[action.object] = action;
    }

    void advance(LocalTime now) override
    {
        if (m_own.empty() || !m_tick.isDue(now))
            return;
        m_tick.served(now);
        for (const auto& [object, action] : m_own) {
            EventCpo snapshot = begunFrom(*running().at(object, now), ownStamp(now), action);
            snapshot.rate = 0.0F;
            sendRelayed(kAllOthers, snapshot);
        }
    }

    [[nodiscard]] LocalTime nextWake() const override
    {
        return m_own.empty() ? LocalTime::max() : m_tick.next();
    }

    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, LocalTime t) const override
    {
        const auto found = m_buffers.find(object);
        if (found == m_buffers.end())
            return RelayedParticipant::shown(object, t);
        return ShownObject{found->second.at(t)};
    }

private:
    void actionReceived(const EventCpo& snapshot, ParticipantId, LocalTime now) override
    {
        m_buffers[snapshot.object].add(snapshot.start, evaluateAfter(snapshot, Duration{}), now);
    }

    StreamTick m_tick;
    std::map<ObjectId, EventCpo> m_own;
    std::map<ObjectId, PlayoutBuffer> m_buffers;
};

} // namespace

SyncStrategy interpolationStrategy()
{
    return {"interpolation", "60 snapshots a second, drawn late by an adaptive buffer",
            RelayHost::make,
            [](const StarSeat& seat, LocalTime) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<InterpolationParticipant>(seat);
            }};
}

} // namespace carina
