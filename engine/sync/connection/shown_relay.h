#pragma once

#include "engine/core/ids.h"
#include "engine/sync/strategies/view_comparison.h"

#include <optional>

namespace carina
{

/// What the owners of objects showed of them, on its way through the host to all others: the newest
/// of each object, at most twice in a period of comparing, however often its owner sends it.
class ShownRelay
{
public:
    static constexpr Duration kInterval = ViewComparison::kPeriod / 2;

    struct Passed {
        ShownPose shown;
        ParticipantId from; ///< the owner, who is not sent it
    };

    void take(const ShownPose& shown, ParticipantId from, LocalTime now);
    /// What is to be passed on now.
    [[nodiscard]] std::vector<Passed> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const { return m_nextDue; }

private:
    struct Entry {
        std::optional<Passed> waiting;
        LocalTime next = LocalTime::min(); ///< when it may be passed on
    };

    std::map<ObjectId, Entry> m_entries;
    LocalTime m_nextDue = LocalTime::max();
};

} // namespace carina
