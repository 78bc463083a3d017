#pragma once

#include "engine/sync/strategies/drift.h"
#include "engine/sync/wire/shown_pose.h"

#include <deque>
#include <map>
#include <optional>

namespace carina
{

/// What this program showed of shared objects at certain session times, the same in all programs,
/// to be compared with what their owners showed then.
class ViewComparison
{
public:
    /// Poses are compared for the session times that are multiples of this.
    static constexpr Duration kPeriod = std::chrono::milliseconds{250};
    /// Poses of an object that are kept: a few seconds, longer than a message is under way.
    static constexpr std::size_t kKept = 20;

    /// The last of those times that is not after t.
    [[nodiscard]] static SessionTime timeBefore(SessionTime t);

    void remember(const ShownPose& shown);
    /// @returns the drift of this program's view from the owner's; nothing where it is not
    ///          remembered what was shown then
    [[nodiscard]] std::optional<Drift> compare(const ShownPose& owners) const;
    void clear() { m_shown.clear(); }

private:
    std::map<ObjectId, std::deque<ShownPose>> m_shown; // the newest last
};

} // namespace carina
