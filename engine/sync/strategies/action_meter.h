#pragma once

#include "engine/sync/strategies/drift.h"
#include "engine/sync/wire/event_cpo.h"

#include <vector>

namespace carina
{

/// Least drift and delay of actions on a shared object, at one node.
struct ActionFigures {
    Drift limit{};    ///< of the last action, while it is under way; see ActionMeter
    Duration delay{}; ///< of the last action, from its start to its arrival
};

/// Measures the actions on one shared object as they arrive at a node.
///
/// The limit is the difference between the previous action and the new one, both evaluated for the
/// shortest delay of any action under this ownership in the last kWindow after its start; 0 where
/// actions arrive no later than they begin, as at their owner. It assumes that a viewer goes on
/// with the old action until it hears of the new one, so it is a limit only for the times between
/// the start of an action and its arrival: from then on nothing keeps views apart (limitAt).
class ActionMeter
{
public:
    static constexpr Duration kWindow = std::chrono::seconds{10};
    static constexpr std::size_t kMostKept = 100;

    /// @param before the action that was in force until then
    /// @param now present session time
    void arrived(const EventCpo& event, const EventCpo& before, SessionTime now);

    [[nodiscard]] const ActionFigures& figures() const { return m_figures; }
    /// The limit of the views of session time t: the largest of the actions that had begun then and
    /// had not arrived; 0 where there was none.
    [[nodiscard]] Drift limitAt(SessionTime t) const;

private:
    struct Arrival {
        SessionTime at;
        std::uint16_t epoch;
        Duration delay;
        Drift limit{};
    };

    std::vector<Arrival> m_arrivals; // the newest last; at most kMostKept
    ActionFigures m_figures;
};

} // namespace carina
