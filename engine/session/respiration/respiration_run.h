#pragma once

#include "engine/lungs/drawing/chest_shape.h"
#include "engine/session/respiration/respiration_facts.h"
#include "engine/session/respiration/respiration_timeline.h"

namespace carina
{

/// Breathes the patient of a station along the session: a RespiratoryFold that takes every setting,
/// pause and breath of the manikin at its effect time. Its steps follow each other from the first
/// moment the session runs, and after a pause from the moment it goes on, so that every node that
/// knows the facts up to a time has the same state then, bit for bit. What was decided before the
/// first step holds from the beginning.
class RespirationRun
{
public:
    /// Stands where the last checkpoint at or before t has it, else before the first breath.
    RespirationRun(const RespirationTimeline& timeline, SessionTime t);

    /// Breathes on up to the last whole step at or before t. `timeline` is the same one, with facts
    /// that came since. Of a longer time between two changes only the last kLongestCatchUp is
    /// breathed, as where the host was down for a night: a screen would stand still for the rest.
    /// Until the next checkpoint, whoever breathed all of it may be at another moment of a breath.
    void advanceTo(const RespirationTimeline& timeline, SessionTime t);

    /// The end of the last step.
    [[nodiscard]] SessionTime at() const { return m_at; }
    [[nodiscard]] const RespiratoryFold& fold() const { return m_fold; }
    /// What is to be drawn.
    [[nodiscard]] ChestShape shape() const;
    /// For those who join later: to be put into the log.
    [[nodiscard]] fact::RespirationCheckpoint checkpoint() const;

private:
    void skipTo(const RespirationTimeline& timeline, SessionTime t);
    void take(const RespiratorySettings& settings);
    void hear(const RespirationTimeline& timeline);
    void forgetBreaths(const RespirationTimeline& timeline);

    SessionTime m_at;
    std::size_t m_heard = 0; ///< breaths of the manikin
    RespiratoryFold m_fold;
};

/// The most that is breathed at once between two changes: 30,000 steps.
inline constexpr Duration kLongestCatchUp = std::chrono::seconds{60};

/// The host puts a checkpoint into the log that often.
inline constexpr Duration kCheckpointEvery = std::chrono::seconds{10};

} // namespace carina
