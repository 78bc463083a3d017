#include "models/station/station_view.h"

#include "engine/anatomy/events/swallow.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/session/lesson_rules.h"
#include "models/patient/shared_patient.h"

#include <algorithm>

namespace carina
{
namespace
{

/// X_UJ of the mandible in the frame of the head, while the probe on it is seen.
std::optional<RigidTransform> jawInHead(const StationMoment& moment, const PatientModel& patient)
{
    if (!moment.jaw || moment.jaw->validity == Validity::Lost)
        return std::nullopt;
    return patient.neck(moment.headPosition).X_AU().inverse() * moment.jaw->X_FO;
}

} // namespace

AirwayEvents airwayEventsAt(const Station& station, const PatientRun& run, SessionTime t)
{
    AirwayEvents events = station.airwayEvents.at(t);
    const auto swallowing =
        std::ranges::find(events, AirwayEventKind::Swallowing, &AirwayEvent::kind);
    if (swallowing != events.end())
        swallowing->severity *= swallowAt(t) * run.body().swallowingLeft();
    worsen(events, {AirwayEventKind::Laryngospasm, run.spasm()});
    return events;
}

bool isAway(const StationMoment& moment)
{
    return moment.patient && !isInItsPlace(moment.patient->acted);
}

JawSight jawSightAt(const StationMoment& moment, const PatientModel& patient)
{
    if (!moment.jaw)
        return JawSight::NoProbe;
    const auto X_UJ = jawInHead(moment, patient);
    if (!X_UJ)
        return JawSight::Lost;
    return patient.reachesJaw(*X_UJ) ? JawSight::Seen : JawSight::Astray;
}

FollowingThroat throatAt(const StationMoment& moment, const PatientModel& patient)
{
    return patient.throat(jawInHead(moment, patient), moment.headPosition, moment.airwayEvents);
}

StationView::StationView(const SessionNode& node, StationId station, const LungPair& lungs,
                         ObjectPoses own)
    : m_node{node}, m_station{station}, m_lungs{lungs}, m_own{std::move(own)}
{
}

void StationView::setStation(StationId station)
{
    m_station = station;
    m_breathing = {};
}

StationMoment StationView::at(SessionTime t, std::size_t level) const
{
    StationMoment moment;
    moment.time = t;
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (station != state->stations().end()) {
        const PatientRun& run = m_breathing.at(station->second.respiration, t);
        moment.breathing = run.shape();
        moment.inspiration = run.fold().inspiration();
        moment.position = station->second.respiration.settingsAt(t).position;
        moment.airwayEvents = airwayEventsAt(station->second, run, t);
        moment.headPosition = headPositionAt(station->second, t);
        moment.isCuffInflated = station->second.respiration.tube().cuffInflatedAt(t);
        moment.tubeIsApart = station->second.respiration.tube().areShapesApartAt(t);
        moment.exaggeration = m_exaggeration;
        const ChestPose drawn = drawnPose(m_lungs, moment.breathing, level);
        moment.notDrawn = notDrawn(m_lungs, moment.breathing, drawn, level);
        moment.pose = exaggerated(drawn, m_exaggeration);
    }
    addPeople(moment, *state);
    addLesson(moment, *state);
    if (const SharedObject* patient = sharedPatient(*state, m_station))
        moment.patient = m_node.shown(patient->id, t);
    moment.lifted = liftedObjects(m_node, m_station, t);
    return moment;
}

void StationView::addPeople(StationMoment& moment, const SessionState& state) const
{
    const SessionTime t = moment.time;
    moment.worker = state.atWork(m_station);
    moment.people = peoplePoses(m_node, m_station, m_own, t);
    moment.ownHandsAreDrawn = m_own.handsAreDrawn;
    moment.head = m_own.at(ObjectKind::Head, t);
    moment.headIsAwaited = m_own.hasTool(ObjectKind::Head);
    const auto self = state.participants().find(m_node.self());
    if (self != state.participants().end())
        moment.turn = self->second.turn;
    if (moment.worker == m_node.self()) { // both are nobody before it is admitted
        moment.tube = m_own.at(ObjectKind::Tube, t);
        moment.jaw = m_own.at(ObjectKind::Jaw, t);
        if (const auto newest = m_own.newest(ObjectKind::Tube))
            moment.sampleAge = t - *newest;
        return;
    }
    if (const PersonPose* tube = atWork(moment.people, ObjectKind::Tube)) {
        moment.tube = tube->pose;
        const auto poses = m_node.object(tube->object);
        if (const auto newest = poses ? poses->newest() : std::nullopt)
            moment.sampleAge = t - newest->time;
        if (poses) {
            moment.tubePoses = poses;
            moment.tubeShape = poses->shapeAt(t);
        }
    }
    if (const PersonPose* jaw = atWork(moment.people, ObjectKind::Jaw))
        moment.jaw = jaw->pose;
}

/// What is pointed with is seen by those to whom something is shown; what is looked at is nothing
/// to be drawn.
void StationView::addLesson(StationMoment& moment, const SessionState& state) const
{
    if (const ShownLesson* lesson = lessonFor(state, m_node.self()))
        moment.lesson = *lesson;
    const auto isShown = [&moment](const PersonPose& person) {
        return moment.lesson && moment.lesson->by == person.owner;
    };
    for (const PersonPose& person : moment.people)
        if (person.kind == ObjectKind::View && isShown(person)
            && person.pose.validity != Validity::Lost)
            moment.lessonView = person.pose;
    std::erase_if(moment.people, [&](const PersonPose& person) {
        return person.kind == ObjectKind::View
               || (person.kind == ObjectKind::Pointer && !person.isOwn && !isShown(person));
    });
}

StationMoment StationView::litAt(LocalTime lit, std::size_t level) const
{
    const std::optional<SessionTime> time = m_node.sessionTime(lit);
    return time ? at(*time, level) : StationMoment{};
}

} // namespace carina
