#pragma once

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

/// A datagram to a direct neighbour in the star.
struct StarDatagram {
    ParticipantId to;
    std::vector<std::byte> bytes;
};

/// A program in a session's star, without socket, clock or thread: inputs are local time and bytes,
/// outputs are bytes and the next wake-up. The same inputs give the same outputs.
///
/// Participants have one neighbour, the host kStarHost; the host has all participants.
class StarNode
{
public:
    virtual ~StarNode() = default;

    virtual void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) = 0;
    /// Sends what is due; called after everything else and at nextWake().
    virtual void advance(LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const { return LocalTime::max(); }
    [[nodiscard]] std::vector<StarDatagram> take() { return std::exchange(m_outgoing, {}); }

    /// Datagrams sent so far for no other purpose than to measure the delay.
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
    /// This participant takes an action on an object that it owns, now. The action's start time is
    /// the strategy's to set; its counter is one above the last on that object.
    virtual void act(const EventCpo& action, LocalTime now) = 0;
    /// What this participant draws at local time t; nothing for an object never heard of.
    [[nodiscard]] virtual std::optional<ShownObject> shown(ObjectId object, LocalTime t) const = 0;
    /// The session's clock, where the strategy has one.
    [[nodiscard]] virtual std::optional<SessionTime> sessionTime(LocalTime) const
    {
        return std::nullopt;
    }
};

/// Who a participant is among those of its session.
struct StarSeat {
    ParticipantId self;
    std::uint16_t participants = 2; ///< 1 to this number, beside the host
};

/// A way to keep shared objects alike everywhere. Adding one takes a file in
/// engine/sync/strategies and a line in strategy.cpp (docs/synchronisation.md).
struct SyncStrategy {
    std::string_view name;
    std::string_view meaning; ///< one line, in English, for help texts
    std::unique_ptr<StarNode> (*makeHost)(std::uint16_t participants, LocalTime now);
    std::unique_ptr<StarParticipant> (*makeParticipant)(const StarSeat& seat, LocalTime now);
};

/// All there are; the first is the default.
[[nodiscard]] std::span<const SyncStrategy> syncStrategies();
/// Nothing for a name that is none.
[[nodiscard]] const SyncStrategy* findSyncStrategy(std::string_view name);

} // namespace carina
