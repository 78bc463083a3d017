#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace carina
{

/// Whether a participant acts less often than an action needs to arrive.
enum class ApplicationCategory : std::uint8_t {
    /// v_k < v0: each action arrives before the next; the case that the ASA is designed for.
    BelowUpshot,
    /// v_k >= v0: a new action begins before the last has arrived; v_k / v0 actions in one delay.
    AboveUpshot,
};

/// The application analysis of Hamza-Lup et al. 2004: how often a participant acts on the shared
/// objects, compared with how often the network lets two sites agree.
///
///     upshot frequency   v0  = 1 / t_xy                        t_xy: one-way delay from x to y
///     action frequency   v_k = (sum over j of b_jk) / (m dt)   (eq. 3)
///
/// b_jk is the number of actions of participant k on object j in the time dt, for the objects j = 1
/// to m. What the paper leaves open is our choice: m is the number of objects that those
/// present own, also those on which k does not act; dt is the kSeconds most recent whole seconds of
/// the session clock, so that all sites count alike, or fewer where fewer have passed since the
/// participant's first action; so v_k of a participant who no longer acts falls to 0. An action is
/// every change of an object's motion (start, replacement by another action, end), and each sample
/// of a tracked object; its participant is the owner of the object then. v_k = v0 counts as above.
/// (The paper prints 1/0.0001 for the v0 of 1 ms; it is 1000 per second.)
///
/// Simultaneous actions each count. Late actions count in the second of their time, if that is
/// within 2 kSeconds of the participant's newest; an action that a later one has overtaken is not
/// reported (SharedActions::take). Each action must be reported once only.
class ApplicationAnalysis
{
public:
    static constexpr int kSeconds = 10;

    /// Counts an action of participant k on object j at time `at`.
    void acted(ParticipantId k, ObjectId j, SessionTime at);
    /// Adds what was counted elsewhere.
    void add(const ApplicationAnalysis& other);
    /// Removes the actions on an object.
    void forget(ObjectId j);
    void clear() { m_counts.clear(); }

    /// Those of whom an action was counted.
    [[nodiscard]] std::vector<ParticipantId> participants() const;
    /// v_k, per second. Nothing for a participant who never acted, or before the second of the
    /// first action is over.
    ///
    /// @param m number of shared objects @pre at least 1
    [[nodiscard]] std::optional<double> actionFrequency(ParticipantId k, std::size_t m,
                                                        SessionTime now) const;

private:
    /// Number of actions in one second, by object.
    using Actions = std::map<ObjectId, std::uint32_t>;
    struct Counts {
        std::int64_t first = 0;                  ///< second of the first action
        std::map<std::int64_t, Actions> seconds; ///< b_jk
    };

    void count(ParticipantId k, ObjectId j, std::int64_t second, std::uint32_t actions);

    std::map<ParticipantId, Counts> m_counts;
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
