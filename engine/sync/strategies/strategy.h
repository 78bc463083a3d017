#pragma once

#include "engine/core/external_time.h"
#include "engine/core/ids.h"
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

/// A participant's end of a synchronisation strategy.
class StarParticipant : public StarNode
{
public:
    /// Begins an action, now, on an object that this participant owns. The strategy sets the start
    /// time; the caller sets the counter, one above the last on that object.
    virtual void act(const EventCpo& action, LocalTime now) = 0;
    /// The object as this participant draws it at local time t; nothing for an unknown object.
    [[nodiscard]] virtual std::optional<ShownObject> shown(ObjectId object, LocalTime t) const = 0;
    /// Session time, for strategies with a session clock.
    [[nodiscard]] virtual std::optional<SessionTime> sessionTime(LocalTime) const
    {
        return std::nullopt;
    }
};

/// Identity of a participant within its session.
struct StarSeat {
    ParticipantId self;
    std::uint16_t participants = 2; ///< their ids are 1 to this number; the host is 0
};

/// A method of keeping shared objects consistent between participants. To add one, write a file in
/// engine/sync/strategies and a line in strategy.cpp (docs/synchronisation.md).
struct SyncStrategy {
    std::string_view name;
    std::string_view meaning; ///< one line, in English, for help texts
    std::unique_ptr<StarNode> (*makeHost)(std::uint16_t participants, LocalTime now);
    std::unique_ptr<StarParticipant> (*makeParticipant)(const StarSeat& seat, LocalTime now);
};

/// All strategies; the first is the default.
[[nodiscard]] std::span<const SyncStrategy> syncStrategies();
/// nullptr for an unknown name.
[[nodiscard]] const SyncStrategy* findSyncStrategy(std::string_view name);

} // namespace carina
