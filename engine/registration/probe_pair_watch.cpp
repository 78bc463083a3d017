#include "engine/registration/probe_pair_watch.h"

#include "engine/geometry/rotation.h"
#include "engine/registration/error_bound.h"

namespace carina
{

void ProbePairWatch::push(SessionTime time, const RigidTransform& X_BJ, Validity validity)
{
    if (validity == Validity::Lost || (m_last && time <= *m_last))
        return;
    if (m_samples == 0 || time - *m_last > m_settings.longestGap) {
        m_from = time;
        m_shifts = Vec3::Zero();
        m_turns = Vec3::Zero();
        m_samples = 0;
    }
    m_last = time;
    m_shifts += X_BJ.translation() - m_registered.translation();
    m_turns += rotationVector(X_BJ.rotation() * m_registered.rotation().conjugate());
    ++m_samples;
    if (time - m_from < m_settings.window)
        return;
    judge(m_from);
    m_samples = 0;
}

void ProbePairWatch::judge(SessionTime from)
{
    const std::optional<SessionTime> since = m_report.since;
    m_report = {.shift_B = m_shifts / m_samples};
    const Vec3 turn_B = m_turns / m_samples;
    m_report.turn = radians(turn_B.norm());
    const Length shift = metres(m_report.shift_B.norm());
    const double ofShift = shift / m_settings.shift;
    const double ofTurn = m_report.turn / m_settings.turn;
    m_report.chance = chiSquaredTail(ofShift * ofShift + ofTurn * ofTurn, 6.0);
    m_report.state = m_report.chance < m_settings.limit ? WatchState::Drifted : WatchState::Good;
    if (m_report.state == WatchState::Drifted)
        m_report.since = since.value_or(from);
}

} // namespace carina
