#pragma once

#include "engine/core/external_time.h"
#include "engine/core/ids.h"
#include "engine/sync/strategies/strategy_choice.h"
#include "engine/sync/wire/event_cpo.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace carina
{

/// A datagram to a neighbour in the star topology.
struct StarDatagram {
    ParticipantId to;
    std::vector<std::byte> bytes;
};

/// A program in a session, without socket, clock or thread: inputs are local time and bytes,
/// outputs are bytes and the next wake-up. The same inputs give the same outputs.
///
/// The topology is a star: participants have one neighbour, the host kStarHost; the host has all
/// participants.
class StarNode
{
public:
    virtual ~StarNode() = default;

    virtual void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) = 0;
    /// Sends what is due. To be called after every other call, and at nextWake().
    virtual void advance(LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const { return LocalTime::max(); }
    [[nodiscard]] std::vector<StarDatagram> take() { return std::exchange(m_outgoing, {}); }
    /// Whether take() has something.
    [[nodiscard]] bool hasOutgoing() const { return !m_outgoing.empty(); }

    /// A reading of this program's clock against one that is disciplined from outside; for
    /// strategies with a session clock.
    virtual void readExternal(const ExternalTime&, LocalTime) {}

    /// Number of datagrams sent only to measure the delay.
    [[nodiscard]] virtual std::uint64_t probesSent() const { return 0; }

protected:
    void send(ParticipantId to, std::vector<std::byte> bytes)
    {
        m_outgoing.push_back({to, std::move(bytes)});
    }

private:
    std::vector<StarDatagram> m_outgoing;
};

inline constexpr ParticipantId kStarHost{0};

class ProbeTrigger;
class RelayedView;

/// A participant's end of a synchronisation strategy.
class StarParticipant : public StarNode
{
public:
    /// Begins an action, now, on an object that this participant owns. The strategy sets the start
    /// time; the caller sets the counter, one above the last on that object, and the pose that the
    /// object has here.
    virtual void act(const EventCpo& action, LocalTime now) = 0;
    /// The object as this participant draws it at local time t; nothing for an unknown object.
    [[nodiscard]] virtual std::optional<ShownObject> shown(ObjectId object, LocalTime t) const = 0;
    /// All that shown() depends on, for strategies without a session clock.
    [[nodiscard]] virtual const RelayedView* view() const { return nullptr; }
    /// Forgets an object; sends nothing about it any more.
    virtual void forget(ObjectId object) = 0;
    /// How the strategy itself probes the path to another participant, with the delays that it goes
    /// by; nullptr for one that measures none, and towards who is not there.
    [[nodiscard]] virtual const ProbeTrigger* triggerTo(ParticipantId) const { return nullptr; }
    /// Participants have come or gone.
    virtual void setOthers(std::span<const ParticipantId>, LocalTime) {}
    /// Session time, for strategies with a session clock.
    [[nodiscard]] virtual std::optional<SessionTime> sessionTime(LocalTime) const
    {
        return std::nullopt;
    }
};

/// Identity of a participant within its session.
struct StarSeat {
    ParticipantId self;
    std::vector<ParticipantId> others; ///< participants
};
/// The seat of a participant where the ids are 1 to a number; the host is 0.
[[nodiscard]] StarSeat starSeat(ParticipantId self, std::uint16_t participants);

/// The ids 1 to a number.
[[nodiscard]] std::vector<ParticipantId> starParticipants(std::uint16_t number);

/// A method of keeping shared objects consistent between participants. To add one, write a file in
/// engine/sync/strategies and a line in strategy.cpp (docs/synchronisation.md).
struct SyncStrategy {
    StrategyKind kind;
    std::string_view name;
    std::string_view meaning; ///< one line, in English, for help texts
    std::unique_ptr<StarNode> (*makeHost)(const std::vector<ParticipantId>& participants,
                                          LocalTime now);
    std::unique_ptr<StarParticipant> (*makeParticipant)(const StarSeat& seat,
                                                        const StrategyChoice& choice,
                                                        LocalTime now);
};

/// All strategies; the first is the default.
[[nodiscard]] std::span<const SyncStrategy> syncStrategies();
/// nullptr for an unknown name.
[[nodiscard]] const SyncStrategy* findSyncStrategy(std::string_view name);
[[nodiscard]] const SyncStrategy& syncStrategy(StrategyKind kind);

} // namespace carina
