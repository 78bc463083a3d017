#include "apps/lab/intubation/watched_airway.h"

#include "engine/anatomy/airway/centreline.h"

namespace carina::lab
{
namespace
{

/// The line with another length: cut, or straight on.
std::vector<Vec3> withLength(std::vector<Vec3> line, double length)
{
    double missing = length - lengthOf(line).si;
    while (missing < 0.0 && line.size() > 2
           && (line.back() - line[line.size() - 2]).norm() <= -missing) {
        missing += (line.back() - line[line.size() - 2]).norm();
        line.pop_back();
    }
    const Vec3 ahead = (line.back() - line[line.size() - 2]).normalized();
    line.back() += missing * ahead;
    return line;
}

} // namespace

AirwayMoment WatchedAirway::take(const SeenTools& tools)
{
    const MotionPatient& patient = *m_subject.motion;
    const NeckField neck{patient.airway.p_A_glottis, patient.airway.p_A_incisors, tools.head};
    const PatientWays ways = waysAt(tools, neck);
    std::vector<Vec3> p_A_shown;
    for (const Vec3& p_E :
         withLength(bent(m_subject.tube, neck).p_E_centre, lengthOf(m_subject.tube.p_E_centre).si))
        p_A_shown.push_back(tools.tube.X_FO * p_E);
    return airwayMoment(
        tools.tube.time, ways,
        {.validity = tools.tube.validity, .p_A_shown = p_A_shown, .p_A_measured = {}},
        bladeAt(tools, neck));
}

PatientWays WatchedAirway::waysAt(const SeenTools& tools, const NeckField& neck) const
{
    const MotionPatient& patient = *m_subject.motion;
    const FollowingThroat throat{patient.throat, tools.jaw.X_FO * patient.held.inverse(), neck};
    return moved(m_subject.ways, [&](const Vec3& p) {
        const Vec3 p_A = neck.placed(p);
        const double share = shareOfJaw(m_subject.ways, p);
        return Vec3{p_A + share * throatPull(throat, ThroatTissue::Airway, p_A).d};
    });
}

BladeSeen WatchedAirway::bladeAt(const SeenTools& tools, const NeckField& neck)
{
    const PoseSample& seen = tools.laryngoscope;
    if (seen.validity == Validity::Lost)
        return {};
    const MotionPatient& patient = *m_subject.motion;
    const FollowingThroat throat{patient.throat, tools.jaw.X_FO * patient.held.inverse(), neck};
    m_effort = m_levering.take(followed(patient.upper, throat), m_blade, seen.X_FO, neck.X_AU());
    return {.validity = seen.validity,
            .p_A_tip = seen.X_FO * middleOfBlade(m_blade.form, 1.0),
            .isOnTeeth = m_effort.isOnTeeth};
}

} // namespace carina::lab
