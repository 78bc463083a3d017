#pragma once

#include "engine/sync/actions/event_repeater.h"

#include <deque>
#include <optional>
#include <unordered_map>

namespace carina
{

/// The actions in force on shared objects. The latest action wins (isLater), in whatever order they
/// arrive.
class EventTable
{
public:
    /// An object is stale when neither an action nor a heartbeat of it arrived for this long.
    static constexpr Duration kStaleAfter = std::chrono::milliseconds{300};
    /// Actions before the newest that are kept because it starts in the future.
    static constexpr std::size_t kMostPending = 64;
    /// An action that starts further ahead than this is refused.
    static constexpr Duration kLargestLead = std::chrono::seconds{10};

    /// What take() did: refused the action, found it older than the newest, the same as the newest,
    /// or a new one.
    enum class Verdict : std::uint8_t { Refused, Old, Known, New };

    /// Stores an action that arrived. @param session present session time, where it is known
    Verdict take(const EventCpo& event, std::optional<SessionTime> session, LocalTime now);

    /// The action in force on an object at session time t. The newest actions may start in the
    /// future: until then it is the one before them. nullptr for an unknown object.
    [[nodiscard]] const EventCpo* inForce(ObjectId object, SessionTime t) const;
    [[nodiscard]] bool isStale(ObjectId object, LocalTime t) const;
    /// The newest action on an object; nullptr for an unknown object.
    [[nodiscard]] const EventCpo* newest(ObjectId object) const;
    /// The newest action on an object if it is the one that `beat` names, else nullptr.
    [[nodiscard]] const EventCpo* named(const EventBeat& beat) const;
    /// The newest action of every object, in no particular order.
    [[nodiscard]] std::vector<EventCpo> newest() const;
    void forget(ObjectId object) { m_entries.erase(object); }

private:
    struct Entry {
        EventCpo newest;
        std::deque<EventCpo> before; ///< what is in force until it starts, the latest last
        LocalTime heard;

        void supersede(const EventCpo& event, std::optional<SessionTime> session);
    };

    std::unordered_map<ObjectId, Entry> m_entries;
};

} // namespace carina
