#include "engine/session/respiration/respiration_run.h"

#include <algorithm>

namespace carina
{

namespace
{

constexpr Duration kFoldStep = std::chrono::milliseconds{2};
static_assert(kRespiratoryStep == 2e-3);

/// Before every session.
constexpr SessionTime kBeforeAll = SessionTime{Duration{SessionTime::min().time_since_epoch() / 4}};

RespiratoryFold startOf(const RespirationTimeline& timeline, const RespirationState* checkpoint)
{
    if (checkpoint)
        return {timeline.settingsAt(checkpoint->at), checkpoint->state};
    return RespiratoryFold{timeline.settingsAt(kBeforeAll)};
}

} // namespace

RespirationRun::RespirationRun(const RespirationTimeline& timeline, SessionTime t)
    : m_at{kBeforeAll}, m_fold{startOf(timeline, timeline.checkpointBefore(t))}
{
    const RespirationState* checkpoint = timeline.checkpointBefore(t);
    if (!checkpoint)
        return;
    m_at = checkpoint->at;
    forgetBreaths(timeline);
}

/// To the last whole step at or before t; the state stays as it is.
void RespirationRun::skipTo(const RespirationTimeline& timeline, SessionTime t)
{
    m_at += (t - m_at) / kFoldStep * kFoldStep;
    forgetBreaths(timeline);
}

/// The last step began with all that had been heard by then.
void RespirationRun::forgetBreaths(const RespirationTimeline& timeline)
{
    const auto breaths = timeline.breaths();
    m_heard = std::size_t(std::ranges::count_if(
        breaths, [this](const HeardBreath& breath) { return breath.heard <= m_at - kFoldStep; }));
}

void RespirationRun::advanceTo(const RespirationTimeline& timeline, SessionTime t)
{
    while (m_at < t) {
        const SessionTime change = timeline.changeAfter(m_at);
        if (!timeline.runsAt(m_at)) {
            if (change > t)
                return take(timeline.settingsAt(t));
            m_at = change;
            continue;
        }
        take(timeline.settingsAt(m_at));
        if (const SessionTime end = std::min(change, t); end - m_at > kLongestCatchUp)
            skipTo(timeline, end - kLongestCatchUp);
        while (m_at < change) {
            if (m_at + kFoldStep > t)
                return;
            hear(timeline);
            m_fold.step();
            m_at += kFoldStep;
        }
    }
}

/// A patient who has not breathed yet is met as the settings have it; later a change comes in.
void RespirationRun::take(const RespiratorySettings& settings)
{
    if (m_fold.hasBegun())
        m_fold.set(settings);
    else if (m_fold.settings() != settings)
        m_fold = RespiratoryFold{settings};
}

void RespirationRun::hear(const RespirationTimeline& timeline)
{
    const auto breaths = timeline.breaths();
    for (; m_heard < breaths.size() && breaths[m_heard].heard <= m_at; ++m_heard)
        m_fold.trigger(toSeconds(m_at - breaths[m_heard].began));
}

ChestShape RespirationRun::shape() const
{
    return chestShape(m_fold.settings().build, m_fold.system(), m_fold.content(), m_fold.moment());
}

fact::RespirationCheckpoint RespirationRun::checkpoint() const { return {m_at, m_fold.state()}; }

} // namespace carina
