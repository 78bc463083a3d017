#pragma once

#include "engine/core/expects.h"
#include "engine/core/session_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace carina
{

/// Some numbers over session time, also while that is paused: 0 at first, and changes in each of
/// which they go evenly to others over a time.
///
/// Changes may be added in any order; of two at the same time the last one added holds. At any time
/// the numbers are the same whatever the order was. A look-up takes O(log n), a change O(1) when it
/// is the newest and O(n) otherwise.
template <std::size_t kNumbers> class RampTimeline
{
public:
    using Numbers = std::array<double, kNumbers>;

    /// Each number goes evenly over the time from what it is at `from` to what it is in `aim`; a
    /// later change ends that where it has come to.
    /// @pre all are finite, and over is not negative
    void set(SessionTime from, const Numbers& aim, Duration over)
    {
        CARINA_EXPECTS(over >= Duration{0}
                       && std::ranges::all_of(aim, [](double x) { return std::isfinite(x); }));
        auto place = std::ranges::lower_bound(m_changes, from, {}, &Change::from);
        if (place == m_changes.end() || place->from != from)
            place = m_changes.insert(place, Change{});
        *place = {from, over, aim, {}};
        for (; place != m_changes.end(); ++place)
            place->begin =
                place == m_changes.begin() ? Numbers{} : numbersAt(*std::prev(place), place->from);
    }
    /// Removes the changes before a time but the one in force then.
    /// @pre none is added any more that is earlier
    void forgetBefore(SessionTime t)
    {
        const auto next = after(t);
        if (next != m_changes.begin())
            m_changes.erase(m_changes.begin(), std::prev(next));
    }

    [[nodiscard]] Numbers at(SessionTime t) const
    {
        const auto next = after(t);
        return next == m_changes.begin() ? Numbers{} : numbersAt(*std::prev(next), t);
    }
    /// Where the change in force at t leads to.
    [[nodiscard]] Numbers decidedAt(SessionTime t) const
    {
        const auto next = after(t);
        return next == m_changes.begin() ? Numbers{} : std::prev(next)->aim;
    }
    /// How long that change takes in all.
    [[nodiscard]] Duration overAt(SessionTime t) const
    {
        const auto next = after(t);
        return next == m_changes.begin() ? Duration{} : std::prev(next)->over;
    }

private:
    struct Change {
        SessionTime from{};
        Duration over{};
        Numbers aim{};
        Numbers begin{}; ///< at `from`
    };

    [[nodiscard]] static Numbers numbersAt(const Change& change, SessionTime t)
    {
        const Duration passed = t - change.from;
        if (passed >= change.over)
            return change.aim;
        const double share = toSeconds(passed) / toSeconds(change.over);
        Numbers now{};
        for (std::size_t i = 0; i < now.size(); ++i)
            now[i] = change.begin[i] + share * (change.aim[i] - change.begin[i]);
        return now;
    }
    [[nodiscard]] auto after(SessionTime t) const
    {
        return std::ranges::upper_bound(m_changes, t, {}, &Change::from);
    }

    std::vector<Change> m_changes; ///< in ascending order of time
};

} // namespace carina
