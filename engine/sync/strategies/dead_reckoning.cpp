#include "engine/geometry/rotation.h"
#include "engine/sync/strategies/relay_host.h"
#include "engine/sync/strategies/relayed_participant.h"
#include "engine/sync/strategies/strategies.h"
#include "engine/sync/streams/stream_tick.h"

#include <cmath>
#include <map>

namespace carina
{
namespace
{

/// Dead reckoning as in Distributed Interactive Simulation (IEEE 1278.1): the owner carries on the
/// state it sent last, as all others do, and sends another when that is off by 3 degrees or 1 m, or
/// after 5 s. Looked at 60 times a second. Others begin when the state arrives.
class DeadReckoningParticipant final : public RelayedParticipant
{
public:
    static constexpr Angle kAngleThreshold = degrees(3.0);
    static constexpr Length kDistanceThreshold = metres(1.0);
    /// DIS has none for a size; a tenth is about as visible.
    static constexpr double kScaleThreshold = 0.1;
    static constexpr Duration kHeartbeat = std::chrono::seconds{5};

    using RelayedParticipant::RelayedParticipant;

    void act(const EventCpo& action, LocalTime now) override
    {
        if (m_own.empty())
            m_tick.served(now);
        m_own[action.object].action = action;
        drawn().begin(action, now);
    }

    void advance(LocalTime now) override
    {
        if (m_own.empty() || !m_tick.isDue(now))
            return;
        m_tick.served(now);
        for (auto& [object, own] : m_own) {
            const auto actual = drawn().at(object, now);
            if (own.sent && now < own.sentAt + kHeartbeat && !isOff(own, *actual, now))
                continue;
            own.sent = begunFrom(*actual, ownStamp(now), own.action);
            own.sentAt = now;
            sendRelayed(kAllOthers, *own.sent);
        }
    }

    void forget(ObjectId object) override
    {
        RelayedParticipant::forget(object);
        m_own.erase(object);
    }

    [[nodiscard]] LocalTime nextWake() const override
    {
        return m_own.empty() ? LocalTime::max() : m_tick.next();
    }

private:
    struct Own {
        EventCpo action;
        std::optional<EventCpo> sent;
        LocalTime sentAt{};
    };

    static bool isOff(const Own& own, const ActedPose& actual, LocalTime now)
    {
        const ActedPose model = evaluateAfter(*own.sent, now - own.sentAt);
        return angleBetween(actual.X_AO.rotation(), model.X_AO.rotation()) > kAngleThreshold
               || metres((actual.X_AO.translation() - model.X_AO.translation()).norm())
                      > kDistanceThreshold
               || std::abs(actual.scale / model.scale - 1.0) > kScaleThreshold;
    }

    void actionReceived(const EventCpo& action, ParticipantId, LocalTime now) override
    {
        drawn().begin(action, now);
    }

    StreamTick m_tick;
    std::map<ObjectId, Own> m_own;
};

} // namespace

SyncStrategy deadReckoningStrategy()
{
    return {StrategyKind::DeadReckoning, "dead-reckoning",
            "DIS: a new state when the one carried on is off by 3 deg or 1 m", RelayHost::make,
            [](const StarSeat& seat, const StrategyChoice&,
               LocalTime) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<DeadReckoningParticipant>(seat.self);
            }};
}

} // namespace carina
