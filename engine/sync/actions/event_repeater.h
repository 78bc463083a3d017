#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/wire/datagram.h"

#include <map>
#include <vector>

namespace carina
{

/// An action to send: whole, or as a heartbeat that only names it.
struct DueEvent {
    EventCpo event;
    bool isBeat = false;

    [[nodiscard]] WireRecord record() const;
};

/// Retransmission of actions in one direction of one connection. The newest action on each object
/// is sent at once, again after 10 ms and 30 ms, and then every 20 ms until it is acknowledged:
/// after a burst of loss, the first repeat that arrives determines the delay.
///
/// The owner of the objects also sends a heartbeat, so that others can tell an object at rest from
/// an owner that is gone: every 100 ms a record names the acknowledged action. This record is as
/// long as its acknowledgement, so that both take equally long through a narrow link, as the clock
/// estimate requires. After kUnanswered heartbeats in a row without an acknowledgement the action
/// is sent whole again.
class EventRepeater
{
public:
    static constexpr Duration kFirstRepeat = std::chrono::milliseconds{10};
    static constexpr Duration kRepeat = std::chrono::milliseconds{20};
    static constexpr Duration kHeartbeat = std::chrono::milliseconds{100};
    /// Shortest time from the last sending of an action to a heartbeat that is forwarded.
    static constexpr Duration kShortestBeat = std::chrono::milliseconds{50};
    /// Heartbeats are forwarded to one participant after the other, at this interval. Sent to all
    /// at once they would be answered at once, and answers that queue for each other bias the clock
    /// estimates.
    static constexpr Duration kTurn = std::chrono::milliseconds{2};
    /// Unacknowledged heartbeats after which an action is sent whole.
    static constexpr int kUnanswered = 10;

    explicit EventRepeater(bool hasHeartbeat) : m_hasHeartbeat{hasHeartbeat} {}

    /// Replaces the action on an object by a new one, to be sent at `due`, or when the one that it
    /// replaces was to be sent first.
    void begin(const EventCpo& event, LocalTime due);
    /// Schedules a heartbeat of an action, to be forwarded at `due`.
    void beat(const EventCpo& event, LocalTime due);
    void acknowledge(const EventAck& ack);
    /// The peer may have lost what it had acknowledged: actions are sent whole again.
    void doubt();
    /// Stops sending for an object.
    void forget(ObjectId object) { m_entries.erase(object); }
    /// Whether the action on the object is not acknowledged yet.
    [[nodiscard]] bool awaits(ObjectId object) const;

    /// Events to send now; they count as sent.
    [[nodiscard]] std::vector<DueEvent> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

private:
    struct Entry {
        EventCpo event;
        LocalTime begun;
        LocalTime due;
        LocalTime lastSent = LocalTime::min(); ///< never yet
        bool isAcknowledged = false;
        int beatsForNothing = 0;
    };

    [[nodiscard]] LocalTime dueAfter(const Entry& entry, LocalTime now) const;

    bool m_hasHeartbeat;
    std::map<ObjectId, Entry> m_entries;
};

/// Whether action a on an object is later than b: by the epoch of the ownership, then by the action
/// counter, then by the start time. The last decides for an owner that was restarted and has not
/// received its earlier count.
[[nodiscard]] bool isLater(const EventCpo& a, const EventCpo& b);

} // namespace carina
