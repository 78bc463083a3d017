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

} // namespace

void DistantTube::lieIn(const PatientModel& patient)
{
    m_patient = &patient;
    m_of.reset();
    m_tube.reset();
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
        m_agreed.reset();
        m_lumen.want(*m_patient, tubeOf(shape, m_patient->ownTube()).outerDiameter);
    }
    if (!m_tube && m_lumen.lumen())
        m_tube.emplace(tubeOf(shape, m_patient->ownTube()), m_lumen.lumen());
    return m_tube.has_value();
}

/// Until when its owner follows it, but no farther than its poses are known.
void DistantTube::follow(const RemoteObject& poses, SessionTime now, const TissueAround& tissue)
{
    const auto newest = poses.newest();
    if (!newest)
        return;
    const auto seen = [&poses](SessionTime t) -> std::optional<RigidTransform> {
        const auto pose = poses.at(t);
        const bool isSeen = pose && pose->validity != Validity::Lost;
        return isSeen ? std::optional{pose->X_FO} : std::nullopt;
    };
    m_tube->follow(std::min(newest->time, now - kReadBehind), seen, tissue);
}

std::optional<std::vector<Vec3>> DistantTube::difference(const RemoteObject& poses)
{
    const SessionTime t = m_tube->laidAt();
    const auto sent = poses.shapeAt(t);
    if (!sent)
        return std::nullopt;
    const TubeShape& patients = m_patient->ownTube();
    std::vector<Vec3> difference = lineOf(*sent, patients);
    const std::vector<Vec3> own = lineOf(toStream(*m_of, patients, m_tube->line(), t), patients);
    double most = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        difference[i] -= own[i];
        most = std::max(most, difference[i].norm());
    }
    if (most < kTooFar.si) {
        m_agreed = t;
        return difference;
    }
    if (!m_agreed)
        m_agreed = t;
    if (t - *m_agreed > kLaidAnew) {
        m_tube->letGo();
        m_agreed = t;
    }
    return std::nullopt;
}

TubeInAirway DistantTube::at(const StationMoment& moment, const TissueAround& tissue)
{
    if (!moment.tube || !moment.tubePoses || !moment.tubeShape) {
        if (m_tube)
            m_tube->letGo();
        return {};
    }
    const TubeDrawing drawing = moment.tubeIsApart ? TubeDrawing::Apart : TubeDrawing::InAirway;
    std::optional<std::vector<Vec3>> off;
    if (isOf(moment.tubeShape->to, moment.time)) {
        follow(*moment.tubePoses, moment.time, tissue);
        if (m_tube->isLaid())
            off = difference(*moment.tubePoses);
    }
    if (!off)
        return {lineOf(*moment.tubeShape, m_patient->ownTube()), drawing};
    std::vector<Vec3> p_E = m_tube->ahead(moment.time, moment.tube->X_FO, tissue);
    for (std::size_t i = 0; i < p_E.size(); ++i)
        p_E[i] += (*off)[i];
    return {std::move(p_E), drawing};
}

} // namespace carina
