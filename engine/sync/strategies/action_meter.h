#pragma once

#include "engine/sync/strategies/drift.h"
#include "engine/sync/wire/event_cpo.h"

#include <vector>

namespace carina
{

/// What the actions on a shared object do to what one node draws.
struct ActionFigures {
    Drift drift;      ///< how far the last moved what was drawn when it arrived
    Drift limit;      ///< nothing moves less: by then nobody could know of it
    Duration delay{}; ///< of the last, from when it was taken to when it arrived
};

/// Measures the actions on one shared object as they arrive at a node.
///
/// The drift is between what the action before it and it have for the time it arrives; none where
/// it is there when it begins, as at whoever took it. The limit is the same for the shortest delay
/// that any action under this ownership had in the last kWindow: a repeat or a queue is in the one
/// but not in the other.
class ActionMeter
{
public:
    static constexpr Duration kWindow = std::chrono::seconds{10};
    static constexpr std::size_t kMostKept = 100;

    /// @param before the action that was in force until then
    /// @param now the session's time
    void arrived(const EventCpo& event, const EventCpo& before, SessionTime now);

    [[nodiscard]] const ActionFigures& figures() const { return m_figures; }

private:
    struct Arrival {
        SessionTime at;
        std::uint16_t epoch;
        Duration delay;
    };

    std::vector<Arrival> m_arrivals; // the newest last; at most kMostKept
    ActionFigures m_figures;
};

} // namespace carina
