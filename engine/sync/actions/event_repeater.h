#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/wire/datagram.h"

#include <map>
#include <vector>

namespace carina
{

/// An action to be sent: whole, or only named, as a sign of life.
struct DueEvent {
    EventCpo event;
    bool isBeat = false;

    [[nodiscard]] WireRecord record() const;
};

/// One direction of one connection: sends the newest action on each object at once, again after
/// 10 ms, after 30 ms, and every further 20 ms until it is acknowledged: what a burst of loss took
/// is not known elsewhere before the first repeat that comes through.
///
/// Whoever owns the objects also has a heartbeat, so that the others can tell an object at rest
/// from an owner that is gone: an acknowledged action is named every 100 ms, in a record as long as
/// its acknowledgement, so that the two take equally long through a narrow path, as the clock
/// wants it. When kUnanswered beats in a row were for nothing the action is sent whole again.
class EventRepeater
{
public:
    static constexpr Duration kFirstRepeat = std::chrono::milliseconds{10};
    static constexpr Duration kRepeat = std::chrono::milliseconds{20};
    static constexpr Duration kHeartbeat = std::chrono::milliseconds{100};
    /// A heartbeat is not passed on sooner than this after the last time the action was sent.
    static constexpr Duration kShortestBeat = std::chrono::milliseconds{50};
    /// Heartbeats are passed on to one participant after the other, so far apart: sent to all at
    /// once they are answered at once, and answers that wait for each other shift the clocks.
    static constexpr Duration kTurn = std::chrono::milliseconds{2};
    static constexpr int kUnanswered = 10;

    explicit EventRepeater(bool hasHeartbeat) : m_hasHeartbeat{hasHeartbeat} {}

    /// A new action on an object, in place of the last.
    void begin(const EventCpo& event, LocalTime now);
    /// A heartbeat of an action is to be passed on at that time.
    void beat(const EventCpo& event, LocalTime due);
    void acknowledge(const EventAck& ack);
    /// The other end may have lost what it had acknowledged.
    void doubt();
    /// The object is another's now.
    void forget(ObjectId object) { m_entries.erase(object); }
    /// Whether an action on the object is under way that nobody acknowledged.
    [[nodiscard]] bool awaits(ObjectId object) const;

    /// Events to send now; they count as sent.
    [[nodiscard]] std::vector<DueEvent> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

private:
    struct Entry {
        EventCpo event;
        LocalTime begun;
        LocalTime due;
        LocalTime lastSent = LocalTime::min();
        bool isAcknowledged = false;
        int beatsForNothing = 0;
    };

    [[nodiscard]] LocalTime dueAfter(const Entry& entry, LocalTime now) const;

    bool m_hasHeartbeat;
    std::map<ObjectId, Entry> m_entries;
};

/// Whether action a on an object is later than b: by the ownership's epoch, then by the counter,
/// and then by the start, for an owner whose program was restarted may not know yet how far it
/// counted.
[[nodiscard]] bool isLater(const EventCpo& a, const EventCpo& b);

} // namespace carina
