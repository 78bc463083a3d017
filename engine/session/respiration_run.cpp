#include "engine/session/respiration_run.h"

#include <algorithm>

namespace carina
{

namespace
{

constexpr Duration kFoldStep = std::chrono::milliseconds{2};
static_assert(kRespiratoryStep == 2e-3);

/// Before every session.
constexpr SessionTime kBeforeAll = SessionTime{Duration{SessionTime::min().time_since_epoch() / 4}};

RespiratorySettings settingsOf(const Station& station, SessionTime t)
{
    return station.respiration.settingsAt(t, station.breathing.settingsAt(t));
}

SessionTime nextChange(const Station& station, SessionTime t)
{
    return std::min(station.respiration.changeAfter(t), station.breathing.changeAfter(t));
}

RespiratoryFold startOf(const Station& station, const RespirationState* checkpoint)
{
    if (checkpoint)
        return {settingsOf(station, checkpoint->at), checkpoint->state};
    return RespiratoryFold{settingsOf(station, kBeforeAll)};
}

} // namespace

RespirationRun::RespirationRun(const Station& station, SessionTime t)
    : m_at{kBeforeAll}, m_fold{startOf(station, station.respiration.checkpointBefore(t))}
{
    const RespirationState* checkpoint = station.respiration.checkpointBefore(t);
    if (!checkpoint)
        return;
    m_at = checkpoint->at;
    // The last step began with all that had been heard by then.
    const auto breaths = station.respiration.breaths();
    m_heard = std::size_t(std::ranges::count_if(
        breaths, [this](const HeardBreath& breath) { return breath.heard <= m_at - kFoldStep; }));
}

void RespirationRun::advanceTo(const Station& station, SessionTime t)
{
    while (m_at < t) {
        const SessionTime change = nextChange(station, m_at);
        if (!station.breathing.runsAt(m_at)) {
            if (change > t)
                return;
            m_at = change;
            continue;
        }
        m_fold.set(settingsOf(station, m_at));
        while (m_at < change) {
            if (m_at + kFoldStep > t)
                return;
            hear(station);
            m_fold.step();
            m_at += kFoldStep;
        }
    }
}

void RespirationRun::hear(const Station& station)
{
    const auto breaths = station.respiration.breaths();
    for (; m_heard < breaths.size() && breaths[m_heard].heard <= m_at; ++m_heard)
        m_fold.trigger(toSeconds(m_at - breaths[m_heard].began));
}

fact::RespirationCheckpoint RespirationRun::checkpoint() const { return {m_at, m_fold.state()}; }

} // namespace carina
