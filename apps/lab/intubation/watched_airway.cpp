#include "apps/lab/intubation/watched_airway.h"

#include "engine/airway/monitor/drawn_ways.h"
#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/airway/jaw_reach.h"

#include <utility>

namespace carina::lab
{
namespace
{

const AirwayField kNoEvents;

} // namespace

WatchedAirway::WatchedAirway(const IntubationSubject& subject, const Blade& blade,
                             ElasticTube::ConnectorAt connectorAt)
    : m_subject{subject}, m_blade{blade}, m_connectorAt{std::move(connectorAt)}
{
    if (subject.lumen)
        m_tube.emplace(subject.tube, subject.lumen);
}

AirwayMoment WatchedAirway::take(const SeenTools& tools)
{
    const FollowingThroat throat = throatOf(tools);
    const BladeField blade = tissueAt(tools, throat);
    followTube(tools, throat, blade);
    const std::vector<Vec3> p_A_measured = measuredTube(tools, throat.neck);
    TubeCurves tube{.validity = tools.tube.validity,
                    .p_A_shown = p_A_measured,
                    .p_A_measured = p_A_measured,
                    .isTipKnown = m_subject.isBendKnown};
    if (m_tube && m_tube->isLaid())
        tube.p_A_shown = m_tube->tube().constrained();
    const AirwayMoment moment =
        airwayMoment(tools.tube.time, drawnWays(m_subject.ways, kNoEvents, throat, blade), tube,
                     bladeAt(tools, throat), m_tube && m_tube->isStoppedAtCords());
    if (moment.tube != Validity::Lost)
        m_isNear = moment.pastTeeth > Length{} - kInFront;
    return moment;
}

FollowingThroat WatchedAirway::throatOf(const SeenTools& tools) const
{
    const MotionPatient& patient = *m_subject.motion;
    const Vec3& p_A_incisors = patient.airway.p_A_incisors;
    const bool isMeasured = tools.jaw.validity != Validity::Lost
                            && isInReachOfJaw(tools.jaw.X_FO, p_A_incisors, patient.upper.size());
    const RigidTransform held = isMeasured ? tools.jaw.X_FO : patient.held;
    return {patient.throat, held * patient.held.inverse(),
            NeckField{patient.airway.p_A_glottis, p_A_incisors, tools.head}};
}

BladeField WatchedAirway::tissueAt(const SeenTools& tools, const FollowingThroat& throat) const
{
    if (tools.laryngoscope.validity == Validity::Lost)
        return {};
    return bladeInTissue(followed(m_subject.motion->upper, throat), m_blade,
                         tools.laryngoscope.X_FO);
}

std::vector<Vec3> WatchedAirway::measuredTube(const SeenTools& tools, const NeckField& neck) const
{
    std::vector<Vec3> line = centreIn(neck, m_subject.tube);
    for (Vec3& p : line)
        p = tools.tube.X_FO * p;
    return line;
}

void WatchedAirway::followTube(const SeenTools& tools, const FollowingThroat& throat,
                               const BladeField& blade)
{
    if (!m_tube)
        return;
    if (!m_isNear) {
        m_tube->letGo();
        return;
    }
    m_tube->follow(tools.tube.time, m_connectorAt, tissueAround(kNoEvents, throat, blade));
}

BladeSeen WatchedAirway::bladeAt(const SeenTools& tools, const FollowingThroat& throat)
{
    const PoseSample& seen = tools.laryngoscope;
    if (seen.validity == Validity::Lost)
        return {};
    m_effort = m_levering.take(followed(m_subject.motion->upper, throat), m_blade, seen.X_FO,
                               throat.neck.X_AU());
    return {.validity = seen.validity, .p_A_tip = seen.X_FO * middleOfBlade(m_blade.form, 1.0)};
}

} // namespace carina::lab
