#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"

#include <map>
#include <optional>

namespace carina
{

/// Whether a shared object is acted on less often than word of it gets around.
enum class ApplicationCategory : std::uint8_t {
    BelowUpshot, ///< v_k < v0: each action has arrived before the next; the ASA is meant for it
    AboveUpshot, ///< v_k >= v0: actions overtake their own news, by so many v_k / v0
};

/// The application analysis of Hamza-Lup et al. 2004: how often shared objects are acted on,
/// against how often the network lets two sites agree.
///
///     upshot frequency   v0  = 1 / t_xy                        t_xy: one-way delay from x to y
///     action frequency   v_k = (sum over j of b_jk) / (m dt)
///
/// b_jk is the number of actions on object k in interval j, of m intervals of length dt. Where the
/// paper leaves the choice, ours is: dt is 1 s; the intervals are whole seconds of the session
/// clock, so that all sites find the same; they are the kIntervals that are complete, and fewer as
/// long as there were fewer since the first action, so that an object not acted on any more comes
/// to 0. An action is whatever changes how the object moves: that it starts, that another takes its
/// place, that it ends; and each sample of a tracked object. v_k = v0 counts as above. (The paper
/// prints 1/0.0001 for the v0 of 1 ms; it is 1000 per second.)
///
/// Actions of one instant count each; those that arrive late or out of order count where they
/// belong, as long as that is within 2 kIntervals of the newest. Give each but once.
class ApplicationAnalysis
{
public:
    using Interval = std::chrono::seconds; ///< dt is one of them
    static constexpr int kIntervals = 10;

    /// Object k was acted on at `at`, by whoever owns it.
    void acted(ObjectId k, SessionTime at);
    /// The object is gone.
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

/// v0, per second, for sites this far apart; nothing for a delay that is not above zero, which no
/// two sites have.
[[nodiscard]] std::optional<double> upshotFrequency(Duration delay);

[[nodiscard]] constexpr ApplicationCategory categoryOf(double actionFrequency,
                                                       double upshotFrequency)
{
    return actionFrequency < upshotFrequency ? ApplicationCategory::BelowUpshot
                                             : ApplicationCategory::AboveUpshot;
}

} // namespace carina
