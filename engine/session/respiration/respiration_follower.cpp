#include "engine/session/respiration/respiration_follower.h"

namespace carina
{
namespace
{

SessionTime checkpointTime(const RespirationTimeline& timeline, SessionTime t)
{
    const RespirationState* checkpoint = timeline.checkpointBefore(t);
    return checkpoint ? checkpoint->at : SessionTime::min();
}

} // namespace

RespirationFollower::Place RespirationFollower::begun(const RespirationTimeline& timeline,
                                                      SessionTime t)
{
    return {PatientRun{timeline, t}, checkpointTime(timeline, t), timeline.decisions()};
}

/// Whether the run can continue to t: no decision since then has an earlier effect time.
bool RespirationFollower::holds(const Place& place, const RespirationTimeline& timeline,
                                SessionTime t)
{
    return place.run.at() <= t && place.checkpoint == checkpointTime(timeline, t)
           && timeline.effectSince(place.decisions) >= place.run.at();
}

const PatientRun& RespirationFollower::at(const RespirationTimeline& timeline, SessionTime t)
{
    if (!m_now || !holds(*m_now, timeline, t))
        m_now = m_before && holds(*m_before, timeline, t) ? *m_before : begun(timeline, t);
    const SessionTime from = m_now->run.at();
    if (!m_before || m_before->run.at() > from || m_before->run.at() + kStepBack < from)
        m_before = m_now;
    m_now->run.advanceTo(timeline, t);
    m_now->decisions = timeline.decisions();
    return m_now->run;
}

} // namespace carina
