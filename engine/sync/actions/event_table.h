#pragma once

#include "engine/sync/actions/event_repeater.h"

#include <optional>
#include <unordered_map>

namespace carina
{

/// The actions in force on shared objects, as they came from elsewhere: the latest wins, by the
/// ownership's epoch and then by the counter, in whatever order they arrive.
class EventTable
{
public:
    /// An object of which nothing was heard for so long is stale.
    static constexpr Duration kStaleAfter = std::chrono::milliseconds{300};
    /// An action that starts further ahead than this is of no session like this one.
    static constexpr Duration kLargestLead = std::chrono::seconds{10};

    enum class Verdict : std::uint8_t { Refused, Old, Known, New };

    /// @param session the session's time now, where it is known
    Verdict take(const EventCpo& event, std::optional<SessionTime> session, LocalTime now);

    /// The object at session time t: of the action before the newest where that has not begun, so
    /// that an action may be announced. Nothing for an object never heard of.
    [[nodiscard]] std::optional<ActedPose> at(ObjectId object, SessionTime t) const;
    /// The action that at() evaluates; nullptr for an object never heard of.
    [[nodiscard]] const EventCpo* inForce(ObjectId object, SessionTime t) const;
    [[nodiscard]] bool isStale(ObjectId object, LocalTime t) const;
    [[nodiscard]] const EventCpo* newest(ObjectId object) const;
    /// The newest action on an object, where it is the one named; nullptr otherwise.
    [[nodiscard]] const EventCpo* named(const EventBeat& beat) const;
    /// Of every object, in any order.
    [[nodiscard]] std::vector<EventCpo> newest() const;
    void forget(ObjectId object) { m_entries.erase(object); }

private:
    struct Entry {
        EventCpo newest;
        std::optional<EventCpo> before;
        LocalTime heard;
    };

    std::unordered_map<ObjectId, Entry> m_entries;
};

} // namespace carina
