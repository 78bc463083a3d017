#pragma once

#include "engine/sync/strategies/playout_buffer.h"

#include <optional>
#include <unordered_map>

namespace carina
{

/// The shared objects as a participant of a relayed strategy shows them. A value: it is copied to
/// the threads that draw.
class RelayedView
{
public:
    /// Shows an action, begun at local time `start`, from now on.
    void begin(const EventCpo& action, LocalTime start);
    /// Shows an object by its snapshots, this one the newest, from now on.
    void addSnapshot(const EventCpo& snapshot, LocalTime now);
    void forget(ObjectId object);

    /// The object at local time t; nothing for an unknown one.
    [[nodiscard]] std::optional<ActedPose> at(ObjectId object, LocalTime t) const;
    /// The action that is shown; nullptr where there is none, or snapshots are.
    [[nodiscard]] const EventCpo* running(ObjectId object) const;
    /// Changes whenever the result of at() may change.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }

private:
    struct Running {
        EventCpo action;
        LocalTime start;
    };

    std::uint64_t m_revision = 0;
    std::unordered_map<ObjectId, Running> m_running;
    std::unordered_map<ObjectId, PlayoutBuffer> m_buffers;
};

} // namespace carina
