#pragma once

#include "engine/lungs/drawing/chest_shape.h"
#include "engine/session/respiration/respiration_facts.h"
#include "engine/session/respiration/respiration_timeline.h"

namespace carina
{

/// Simulates the breathing of a station's patient along the session: a RespiratoryFold that applies
/// every setting, pause and breath of the manikin at its effect time. Steps start when the session
/// first runs, and continue after a pause when it runs again, so that every node that has the facts
/// up to a time has the same state at it, bit for bit. Settings decided before the first step hold
/// from the start.
class RespirationRun
{
public:
    /// Starts from the last checkpoint at or before t, else before the first breath.
    RespirationRun(const RespirationTimeline& timeline, SessionTime t);

    /// Advances to the last whole step at or before t. `timeline` is the same one as before, and
    /// may have grown. Of a longer time between two changes only the last kLongestCatchUp is
    /// simulated, as after a host was down for a night, because a screen would freeze meanwhile.
    /// Until the next checkpoint a node that simulated all of it may then be at a different phase
    /// of a breath.
    void advanceTo(const RespirationTimeline& timeline, SessionTime t);

    /// Session time at the end of the last step.
    [[nodiscard]] SessionTime at() const { return m_at; }
    [[nodiscard]] const RespiratoryFold& fold() const { return m_fold; }
    /// The state to draw.
    [[nodiscard]] ChestShape shape() const;
    /// The present state as a fact for the log, for participants that join later.
    [[nodiscard]] fact::RespirationCheckpoint checkpoint() const;

private:
    void skipTo(const RespirationTimeline& timeline, SessionTime t);
    void take(const RespiratorySettings& settings);
    void hear(const RespirationTimeline& timeline);
    void forgetBreaths(const RespirationTimeline& timeline);

    SessionTime m_at;
    std::size_t m_heard = 0; ///< number of manikin breaths applied
    RespiratoryFold m_fold;
};

/// The most that is simulated between two changes: 30,000 steps.
inline constexpr Duration kLongestCatchUp = std::chrono::seconds{60};

/// Interval of checkpoints that the host puts into the log.
inline constexpr Duration kCheckpointEvery = std::chrono::seconds{10};

} // namespace carina
