#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"

#include <map>
#include <optional>

namespace carina
{

/// Whether a shared object is acted on less often than an action needs to arrive.
enum class ApplicationCategory : std::uint8_t {
    /// v_k < v0: each action arrives before the next; the case that the ASA is designed for.
    BelowUpshot,
    /// v_k >= v0: a new action begins before the last has arrived; v_k / v0 actions in one delay.
    AboveUpshot,
};

/// The application analysis of Hamza-Lup et al. 2004: how often shared objects are acted on,
/// compared with how often the network lets two sites agree.
///
///     upshot frequency   v0  = 1 / t_xy                        t_xy: one-way delay from x to y
///     action frequency   v_k = (sum over j of b_jk) / (m dt)
///
/// b_jk is the number of actions on object k in interval j, of m intervals of length dt. What the
/// paper leaves open is our choice: dt is 1 s; intervals are whole seconds of the session clock, so
/// that all sites count alike; m is the kIntervals most recent complete intervals, or fewer where
/// fewer have passed since the first action, so that v_k of an object that is no longer acted on
/// falls to 0. An action is every change of an object's motion (start, replacement by another
/// action, end), and each sample of a tracked object. v_k = v0 counts as above. (The paper prints
/// 1/0.0001 for the v0 of 1 ms; it is 1000 per second.)
///
/// Simultaneous actions each count. Late or reordered actions count in the interval of their time,
/// if that is within 2 kIntervals of the newest. Each action must be reported once only.
class ApplicationAnalysis
{
public:
    /// Length dt of an interval.
    using Interval = std::chrono::seconds; ///< dt is one of them
    static constexpr int kIntervals = 10;

    /// Counts an action on object k at time `at`, by its owner.
    void acted(ObjectId k, SessionTime at);
    /// Removes an object.
    void forget(ObjectId k) { m_counts.erase(k); }
    void clear() { m_counts.clear(); }

    /// v_k, per second. Nothing for an object never acted on, or before the interval of its first
    /// action is complete.
    [[nodiscard]] std::optional<double> actionFrequency(ObjectId k, SessionTime now) const;

private:
    struct Counts {
        std::int64_t first = 0;                        ///< interval with the first action
        std::map<std::int64_t, std::uint32_t> actions; ///< b_jk by interval j
    };

    std::map<ObjectId, Counts> m_counts;
};

/// v0, per second, for sites with this one-way delay; nothing for a delay of 0 or less.
[[nodiscard]] std::optional<double> upshotFrequency(Duration delay);

[[nodiscard]] constexpr ApplicationCategory categoryOf(double actionFrequency,
                                                       double upshotFrequency)
{
    return actionFrequency < upshotFrequency ? ApplicationCategory::BelowUpshot
                                             : ApplicationCategory::AboveUpshot;
}

} // namespace carina
