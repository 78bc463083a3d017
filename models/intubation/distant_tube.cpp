#include "models/intubation/distant_tube.h"

#include "engine/airway/monitor/intubation_monitor.h"
#include "engine/net/objects/remote_object.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

// Beyond what is sold, and no more than a tube can be bent: of ours.
constexpr Length kShortest = millimetres(100.0);
constexpr Length kLongest = millimetres(500.0);
constexpr Length kThinnest = millimetres(2.5); ///< outer diameter
constexpr Length kThickest = millimetres(15.0);
constexpr double kMostAtRest = 20.0; ///< per metre

bool isTube(const StreamShape& shape)
{
    if (shape.isOfPatientsTube())
        return true;
    return shape.length >= kShortest.si && shape.length <= kLongest.si
           && shape.thickness >= kThinnest.si && shape.thickness <= kThickest.si
           && std::ranges::all_of(
               shape.atRest, [](double perMetre) { return std::abs(perMetre) <= kMostAtRest; });
}

TubeShape tubeOf(const StreamShape& shape, const TubeShape& own)
{
    if (shape.isOfPatientsTube())
        return own;
    const TubeRest rest = restOf(shape);
    TubeShape tube;
    tube.p_E_centre = centrelineOfTube(rest);
    tube.outerDiameter = rest.outerDiameter;
    tube.fitsAirway = false;
    return tube;
}

ElasticTube::ConnectorAt connectorOf(const RemoteObject& poses)
{
    return [&poses](SessionTime t) -> std::optional<RigidTransform> {
        const auto pose = poses.at(t);
        const bool isSeen = pose && pose->validity != Validity::Lost;
        return isSeen ? std::optional{pose->X_FO} : std::nullopt;
    };
}

} // namespace

void DistantTube::lieIn(const PatientModel& patient)
{
    m_patient = &patient;
    m_of.reset();
    m_tube.reset();
    m_compared.reset();
    m_off.reset();
    m_agreed.reset();
}

/// Whether there is a rod of this tube here. Its lumen is measured anew where it has another
/// thickness.
bool DistantTube::isOf(const StreamShape& shape, SessionTime now)
{
    if (!isTube(shape))
        return false;
    if (!m_of || !m_of->isOfSameObject(shape)) {
        if (m_of && now - m_since < kSameTube)
            return false;
        m_of = shape;
        m_since = now;
        m_tube.reset();
        m_compared.reset();
        m_off.reset();
        m_agreed.reset();
        m_lumen.want(*m_patient, tubeOf(shape, m_patient->ownTube()).outerDiameter);
    }
    if (!m_tube && m_lumen.lumen())
        m_tube.emplace(tubeOf(shape, m_patient->ownTube()), m_lumen.lumen());
    return m_tube.has_value();
}

/// Until when its owner follows it, but no farther than its poses are known, and not beyond the
/// form with which it will be compared.
void DistantTube::follow(const RemoteObject& poses, SessionTime now, SessionTime sent,
                         const TissueAround& tissue)
{
    if (const auto newest = poses.newest())
        m_tube->follow(std::min({newest->time, now - kReadBehind, sent}), connectorOf(poses),
                       tissue);
}

/// With the form that was sent, at the moment for which its owner found it.
void DistantTube::compare(const StreamShape& sent, const RemoteObject& poses,
                          const TissueAround& tissue)
{
    if (m_compared == sent.time)
        return;
    m_compared = sent.time;
    m_off.reset();
    const auto connectorAt = connectorOf(poses);
    const auto X_AE = connectorAt(sent.time);
    if (!X_AE)
        return;
    const TubeShape& patients = m_patient->ownTube();
    const std::vector<Vec3> here = m_tube->ahead(sent.time, *X_AE, connectorAt, tissue);
    const std::vector<Vec3> own = lineOf(toStream(*m_of, patients, here, sent.time), patients);
    std::vector<Vec3> off = lineOf(sent, patients);
    double most = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        off[i] -= own[i];
        most = std::max(most, off[i].norm());
    }
    if (!m_agreed || most < kTooFar.si)
        m_agreed = sent.time;
    if (most < kTooFar.si) {
        m_off = std::move(off);
    } else if (sent.time - *m_agreed > kLaidAnew) {
        if (layAs(sent, poses, tissue))
            m_agreed = sent.time;
    }
}

/// Its curve at rest alone may have its tip in another way than its owner's went.
bool DistantTube::layAs(const StreamShape& sent, const RemoteObject& poses,
                        const TissueAround& tissue)
{
    const Vec3 p_E_tip = lineOf(sent, m_patient->ownTube()).back();
    return m_tube->layAnew(sent.time, p_E_tip, sent.heldBack > 0.0, connectorOf(poses), tissue);
}

TubeInAirway DistantTube::at(const StationMoment& moment, const TissueAround& tissue)
{
    const TubeDrawing drawing = moment.tubeIsApart ? TubeDrawing::Apart : TubeDrawing::InAirway;
    if (moment.tube && moment.tubePoses && !moment.tubeShape && isKept(moment.time)) {
        follow(*moment.tubePoses, moment.time, SessionTime::max(), tissue);
        return {drawn(moment, tissue), drawing};
    }
    if (!moment.tube || !moment.tubePoses || !moment.tubeShape) {
        if (m_tube)
            m_tube->letGo();
        m_compared.reset();
        m_off.reset();
        return {};
    }
    m_formAt = moment.time;
    const StreamShape& sent = moment.tubeShape->to;
    const bool isThere = isOf(sent, moment.time);
    if (isThere && (m_tube->isLaid() || layAs(sent, *moment.tubePoses, tissue))) {
        follow(*moment.tubePoses, moment.time, sent.time, tissue);
        compare(sent, *moment.tubePoses, tissue);
    }
    if (!isThere || !m_tube->isLaid())
        return {lineOf(*moment.tubeShape, m_patient->ownTube()), drawing};
    return {drawn(moment, tissue), drawing};
}

/// Whether its rod is drawn though no form is known.
bool DistantTube::isKept(SessionTime now) const
{
    return m_tube && m_tube->isLaid() && m_formAt && now - *m_formAt <= kKeptWithout;
}

std::vector<Vec3> DistantTube::drawn(const StationMoment& moment, const TissueAround& tissue) const
{
    std::vector<Vec3> p_E =
        m_tube->ahead(moment.time, moment.tube->X_FO, connectorOf(*moment.tubePoses), tissue);
    for (std::size_t i = 0; m_off && i < p_E.size(); ++i)
        p_E[i] += (*m_off)[i];
    return p_E;
}

} // namespace carina
