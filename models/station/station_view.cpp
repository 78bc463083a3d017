#include "models/station/station_view.h"

#include "engine/lungs/drawing/chest_drawing.h"
#include "models/patient/shared_patient.h"

namespace carina
{
namespace
{

ToolRole toolOf(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Head:
        return ToolRole::Head;
    case ObjectKind::Jaw:
        return ToolRole::Jaw;
    case ObjectKind::Tube:
        return ToolRole::Tube;
    case ObjectKind::Stylus:
        return ToolRole::Stylus;
    case ObjectKind::Patient:
        break;
    }
    return ToolRole::Other;
}

/// The object of this kind at the station that was seen last, or null: of several
/// trainees who came and went, the one who is at work.
std::shared_ptr<const RemoteObject> sharedPoses(const SessionNode& node, StationId station,
                                                ObjectKind kind)
{
    std::shared_ptr<const RemoteObject> latest;
    SessionTime seen = SessionTime::min();
    const auto state = node.state();
    for (const auto& [id, object] : state->objects()) {
        if (object.station != station || object.kind != kind)
            continue;
        const auto poses = node.object(id);
        const auto newest = poses ? poses->newest() : std::nullopt;
        if (newest && newest->time > seen) {
            seen = newest->time;
            latest = poses;
        }
    }
    return latest;
}

} // namespace

ObjectPoses posesOf(const StationTracking& tracking)
{
    return {
        .at = [&tracking](ObjectKind kind, SessionTime t) { return tracking.at(toolOf(kind), t); },
        .newest = [&tracking](ObjectKind kind) -> std::optional<SessionTime> {
            const auto sample = tracking.newest(toolOf(kind));
            return sample ? std::optional{sample->time} : std::nullopt;
        }};
}

ObjectPoses posesOf(const SessionNode& node, StationId station)
{
    return {.at = [&node, station](ObjectKind kind, SessionTime t) -> std::optional<PoseSample> {
                const auto poses = sharedPoses(node, station, kind);
                return poses ? poses->at(t) : std::nullopt;
            },
            .newest = [&node, station](ObjectKind kind) -> std::optional<SessionTime> {
                const auto poses = sharedPoses(node, station, kind);
                const auto sample = poses ? poses->newest() : std::nullopt;
                return sample ? std::optional{sample->time} : std::nullopt;
            }};
}

bool isAway(const StationMoment& moment)
{
    return moment.patient && !isInItsPlace(moment.patient->acted);
}

StationView::StationView(const SessionNode& node, StationId station, const LungPair& lungs,
                         ObjectPoses poses)
    : m_node{node}, m_station{station}, m_lungs{lungs}, m_poses{std::move(poses)}
{
}

void StationView::setStation(StationId station, ObjectPoses poses)
{
    m_station = station;
    m_poses = std::move(poses);
    m_breathing = {};
}

StationMoment StationView::at(SessionTime t, std::size_t level) const
{
    StationMoment moment;
    moment.time = t;
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (station != state->stations().end()) {
        moment.breathing = m_breathing.at(station->second.respiration, t).shape();
        moment.exaggeration = m_exaggeration;
        const ChestPose drawn = drawnPose(m_lungs, moment.breathing, level);
        moment.notDrawn = notDrawn(m_lungs, moment.breathing, drawn, level);
        moment.pose = exaggerated(drawn, m_exaggeration);
    }
    moment.tube = m_poses.at(ObjectKind::Tube, t);
    moment.jaw = m_poses.at(ObjectKind::Jaw, t);
    moment.head = m_poses.at(ObjectKind::Head, t);
    if (const SharedObject* patient = sharedPatient(*state, m_station))
        moment.patient = m_node.shown(patient->id, t);
    if (const auto newest = m_poses.newest(ObjectKind::Tube))
        moment.sampleAge = t - *newest;
    return moment;
}

StationMoment StationView::litAt(LocalTime lit, std::size_t level) const
{
    const std::optional<SessionTime> time = m_node.sessionTime(lit);
    return time ? at(*time, level) : StationMoment{};
}

} // namespace carina
