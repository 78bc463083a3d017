#include "models/intubation/intubation_watch.h"

#include "engine/airway/monitor/drawn_ways.h"
#include "engine/anatomy/events/swallow.h"
#include "engine/session/body/noted_so_far.h"
#include "engine/session/news_rules.h"
#include "engine/session/respiration/respiration_timeline.h"
#include "models/intubation/sent_shape.h"
#include "models/patient/shared_patient.h"
#include "models/session/proposed.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// After a longer pause of this program the moments between are left out.
constexpr Duration kLongestSkip = std::chrono::milliseconds{500};
/// A step that was not taken, and is older than this with the answer, came too late.
constexpr Duration kTooLate = kLongestNews - std::chrono::milliseconds{500};
/// A program shows what came of its proposals up to 0.1 s later than that they were answered, while
/// it catches up; of ours, with a margin.
constexpr Duration kShownAfter = std::chrono::milliseconds{500};
constexpr double kShutSpasm = 0.95; ///< severity from which no tube passes the cords; of ours

SessionTime wholeMultiple(SessionTime t)
{
    return SessionTime{t.time_since_epoch() / IntubationWatch::kEach * IntubationWatch::kEach};
}

} // namespace

IntubationWatch::IntubationWatch(SessionNode& node, StationId station, ObjectPoses own,
                                 QObject* parent)
    : QObject{parent}, m_node{node}, m_station{station}, m_own{std::move(own)}
{
    m_node.publishShape(ObjectKind::Tube, [board = m_shape]() -> std::optional<StreamShape> {
        const auto shape = board->load();
        return shape ? std::optional{*shape} : std::nullopt;
    });
    connect(&m_lumen, &PatientLumen::measured, this, &IntubationWatch::lumenMeasured);
    m_timer.callOnTimeout(this, &IntubationWatch::look);
    m_timer.start(std::chrono::duration_cast<std::chrono::milliseconds>(kEach));
}

void IntubationWatch::setStation(StationId station)
{
    if (std::exchange(m_station, station) != station)
        forget();
}

void IntubationWatch::lieIn(const PatientModel& patient)
{
    m_patient = &patient;
    m_ways.reset();
    m_tube.reset(); // it has another curve, if not another lumen
    if (m_laryngoscope)
        m_laryngoscope->lieIn(patient);
    else
        m_laryngoscope.emplace(patient);
    forget();
}

void IntubationWatch::forget()
{
    m_monitor = IntubationMonitor{};
    m_isTakenUp = false;
    m_rest = {};
    if (m_tube)
        m_tube->letGo();
    m_shape->store(nullptr);
    m_taken.reset();
    m_controls.reset();
    m_breathing = {};
    m_breaths = {};
    m_queued.clear();
    m_sent.reset();
    m_late = 0;
    m_way = kUsualWay;
    m_noted.clear();
}

/// Where somebody worked before; on the clock of the monitor.
void IntubationWatch::takeUp(SessionTime now)
{
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (m_isTakenUp || station == state->stations().end())
        return;
    m_isTakenUp = true;
    const TubeTimeline& tube = station->second.respiration.tube();
    const NotedSoFar noted = notedSoFar(tube);
    m_monitor = IntubationMonitor{{}, courseFrom(noted, SessionTime{state->runningTime(now)})};
    if (noted.breath)
        m_breaths = TubeBreathWatch{*noted.breath};
    if (tube.notedAt(SessionTime::max()).innerDiameter == m_patient->tube().innerDiameter)
        m_rest.note(m_monitor.told(IntubationStep::AtRest, now)); // else it is noted with its own
}

void IntubationWatch::expectPoses()
{
    const auto standing = m_standing();
    m_monitor.expect({.boundAtCords = standing ? standing->error : Length{}});
}

bool IntubationWatch::knowsTip() const
{
    const auto standing = m_standing();
    if (!standing || standing->state == RegistrationState::Simulated)
        return true;
    const bool isPlaced = standing->state == RegistrationState::Good
                          || standing->state == RegistrationState::Unverified;
    return isPlaced && tellsWhereItLies();
}

/// In session time.
IntubationEvent IntubationWatch::onClock(IntubationEvent event) const
{
    event.at = m_node.state()->whenRan(event.at.time_since_epoch());
    return event;
}

bool IntubationWatch::isAtWork() const
{
    return m_patient != nullptr && m_node.self() != kNobody
           && m_node.state()->atWork(m_station) == m_node.self();
}

void IntubationWatch::look()
{
    const auto now = m_node.now();
    if (!now || !isAtWork()) {
        forget(); // whoever works meanwhile has another tube
        return;
    }
    takeUp(*now);
    const bool isRunning = m_node.state()->phaseAt(*now) == SessionPhase::Running;
    findLumen();
    takeMoments(*now, isRunning);
    shareShape();
    if (!isRunning)
        return;
    takeControls(*now);
    takeBreath(*m_taken);
    propose(*now);
}

void IntubationWatch::findLumen()
{
    if (m_tube)
        return;
    m_lumen.want(*m_patient);
    if (m_lumen.lumen())
        m_tube.emplace(m_patient->tube(), m_lumen.lumen());
}

void IntubationWatch::takeMoments(SessionTime now, bool isRunning)
{
    if (!isRunning && !m_tube) {
        m_taken.reset();
        m_monitor.lookAway();
        return;
    }
    if (!m_ways)
        m_ways = waysOf(*m_patient);
    expectPoses();
    const SessionTime until = wholeMultiple(now - kReadBehind);
    if (!m_taken || until - *m_taken > kLongestSkip)
        m_taken = until - kEach;
    while (*m_taken < until) {
        *m_taken += kEach;
        AirwayMoment moment = airwayAt(*m_taken);
        if (!isRunning || m_node.state()->pauses().contains(*m_taken)) {
            m_monitor.lookAway();
            continue;
        }
        moment.at = SessionTime{m_node.state()->runningTime(*m_taken)};
        for (const IntubationEvent& event : m_monitor.take(moment))
            queue(onClock(event));
        if (const auto rest = m_rest.take(m_monitor))
            queue(onClock(*rest));
    }
}

/// What moves tube, blade and tissue; the chest does not.
StationMoment IntubationWatch::momentAt(SessionTime t)
{
    StationMoment moment;
    moment.time = t;
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (station != state->stations().end()) {
        const PatientRun& run = m_breathing.at(station->second.respiration, t);
        moment.airwayEvents = airwayEventsAt(station->second, run, t);
        moment.headPosition = headPositionAt(station->second, t);
    }
    moment.worker = state->atWork(m_station);
    moment.people = peoplePoses(m_node, m_station, m_own, t);
    moment.tube = m_own.at(ObjectKind::Tube, t);
    moment.jaw = m_own.at(ObjectKind::Jaw, t);
    if (const SharedObject* patient = sharedPatient(*state, m_station))
        moment.patient = m_node.shown(patient->id, t);
    return moment;
}

IntubationWatch::Surroundings IntubationWatch::surroundingsAt(SessionTime t)
{
    StationMoment moment = momentAt(t);
    FollowingThroat throat = throatAt(moment, *m_patient);
    AirwayField changes = m_laryngoscope->changesAt(moment);
    LaryngoscopeSight sight = m_laryngoscope->at(moment, throat);
    return {std::move(moment), std::move(throat), std::move(changes), std::move(sight)};
}

AirwayMoment IntubationWatch::airwayAt(SessionTime t)
{
    const Surroundings around = surroundingsAt(t);
    const auto& [moment, throat, changes, sight] = around;
    const PatientWays ways = drawnWays(*m_ways, changes, throat, sight.tissue);
    followTube(moment, around.tissue());
    TubeCurves tube;
    std::vector<Vec3> measured;
    if (moment.tube && !isAway(moment)) {
        tube.validity = moment.tube->validity;
        measured = measuredTube(*m_patient, throat.neck, moment.tube->X_FO);
        tube.p_A_measured = measured;
        tube.isTipKnown = knowsTip();
        tube.p_A_shown = tellsWhereItLies() ? m_tube->tube().constrained() : measured;
    }
    return airwayMoment(t, ways, tube, bladeIn(moment, sight), isShut(moment));
}

/// The rod of a tube whose curve at rest was touched. One that is only taken to have the form of
/// the airway is drawn as a rod, and told as it is measured: there that form is the better guess.
bool IntubationWatch::tellsWhereItLies() const
{
    return m_tube && m_tube->isLaid() && !m_patient->tube().fitsAirway;
}

/// To this tube: by a spasm, by a swallow, or by whatever stops it above the cords.
bool IntubationWatch::isShut(const StationMoment& moment) const
{
    const AirwayEvents& events = moment.airwayEvents;
    const double swallow = severityOf(events, AirwayEventKind::Swallowing);
    if (std::max(severityOf(events, AirwayEventKind::Laryngospasm), cordsInSwallow(swallow))
        >= kShutSpasm)
        return true;
    return tellsWhereItLies() && m_tube->isStoppedAtCords();
}

/// Beside a patient who is moved away it lies in no lumen.
void IntubationWatch::followTube(const StationMoment& moment, const TissueAround& tissue)
{
    if (!m_tube)
        return;
    if (isAway(moment)) {
        m_tube->letGo();
        return;
    }
    m_tube->follow(moment.time, connectorAt(), tissue);
}

ElasticTube::ConnectorAt IntubationWatch::connectorAt() const
{
    return [this](SessionTime t) -> std::optional<RigidTransform> {
        const auto tube = m_own.at(ObjectKind::Tube, t);
        const bool isSeen = tube && tube->validity != Validity::Lost;
        return isSeen ? std::optional{tube->X_FO} : std::nullopt;
    };
}

TubeInAirway IntubationWatch::tubeAt(const StationMoment& moment, const TissueAround& tissue) const
{
    const bool isSeen = moment.tube && moment.tube->validity != Validity::Lost;
    const bool isOwn = isAtWork() && moment.worker == m_node.self();
    if (!isSeen || !isOwn || isAway(moment))
        return {};
    if (!m_tube)
        return {{}, m_lumen.isImpossible() ? TubeDrawing::NoLumen : TubeDrawing::Awaited};
    if (!m_tube->isLaid())
        return {};
    return {m_tube->ahead(moment.time, moment.tube->X_FO, connectorAt(), tissue),
            course().shapes.isIn ? TubeDrawing::Apart : TubeDrawing::InAirway};
}

/// At the newest pose, from which the next picture here begins, too.
void IntubationWatch::shareShape()
{
    const auto newest = m_own.newest(ObjectKind::Tube);
    const auto before = m_shape->load();
    if (newest && before && *newest - before->time < kShapeEach)
        return;
    m_shape->store(newest && m_tube && m_tube->isLaid() ? shapeAt(*newest) : nullptr);
}

/// Null where it does not bend.
std::shared_ptr<const StreamShape> IntubationWatch::shapeAt(SessionTime t)
{
    const Surroundings around = surroundingsAt(t);
    const auto& tube = around.moment.tube;
    if (!tube || tube->validity == Validity::Lost || isAway(around.moment))
        return nullptr;
    return std::make_shared<const StreamShape>(
        toStream(atRest(m_patient->tube()), m_patient->ownTube(),
                 m_tube->ahead(t, tube->X_FO, connectorAt(), around.tissue()), t));
}

BladeSeen IntubationWatch::bladeIn(const StationMoment& moment, const LaryngoscopeSight& sight)
{
    const bool isSeen =
        sight.state == LaryngoscopeState::Outside || sight.state == LaryngoscopeState::Live;
    if (!isSeen || !sight.isOfWorker)
        return {};
    const auto view = m_view();
    return {.validity = laryngoscopeOf(moment)->pose.validity,
            .p_A_tip = sight.X_AL * middleOfBlade(sight.blade.form, 1.0),
            .glottis = view ? std::optional{view->opening} : std::nullopt};
}

IntubationWatch::Controls IntubationWatch::controlsAt(SessionTime t) const
{
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (station == state->stations().end())
        return {};
    const TubeTimeline& tube = station->second.respiration.tube();
    return {.isCuffInflated = tube.cuffInflatedAt(t), .isStyletIn = tube.styletInAt(t)};
}

void IntubationWatch::takeControls(SessionTime now)
{
    const Controls present = controlsAt(now);
    const Controls before = std::exchange(m_controls, present).value_or(present);
    const auto tell = [&](IntubationStep step) { queue(m_monitor.told(step, now)); };
    if (present.isCuffInflated && !before.isCuffInflated)
        tell(IntubationStep::CuffInflated);
    // That of a tube that is out is empty without anybody's doing.
    if (!present.isCuffInflated && before.isCuffInflated && course().teeth.isIn)
        tell(IntubationStep::CuffDeflated);
    if (before.isStyletIn && !present.isStyletIn)
        tell(IntubationStep::StyletOut);
}

void IntubationWatch::takeBreath(SessionTime t)
{
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (station == state->stations().end())
        return;
    const TubeTimeline& tube = station->second.respiration.tube();
    const PatientRun& run = m_breathing.at(station->second.respiration, t);
    const TubeSeat seat = tube.isOverriddenAt(t) ? tube.overrideAt(t).seat : course().seat;
    if (const auto began = m_breaths.take(run, seat))
        queue(m_monitor.told(IntubationStep::FirstBreath, *began));
}

/// Shapes that come together before it could be noted that they are apart, or the other way, are no
/// step: where they go to and fro faster than the session takes it, other steps would wait.
bool IntubationWatch::isTakenBack(IntubationStep step)
{
    if (step != IntubationStep::ShapesApart && step != IntubationStep::ShapesTogether)
        return false;
    const IntubationStep before = step == IntubationStep::ShapesApart
                                      ? IntubationStep::ShapesTogether
                                      : IntubationStep::ShapesApart;
    const auto unsent = m_queued.begin() + (m_sent ? 1 : 0);
    const auto waiting =
        std::find_if(unsent, m_queued.end(),
                     [before](const IntubationEvent& each) { return each.step == before; });
    if (waiting == m_queued.end())
        return false;
    m_queued.erase(waiting);
    return true;
}

void IntubationWatch::queue(const IntubationEvent& event)
{
    if (isTakenBack(event.step))
        return;
    m_rest.note(event);
    const bool isRest = event.step == IntubationStep::AtRest;
    const std::size_t unsent = m_queued.size() - (m_sent ? 1 : 0);
    if (isRest && unsent > 0 && m_queued.back().step == IntubationStep::AtRest)
        m_queued.pop_back(); // it rests elsewhere now
    else if (m_queued.size() == kMostQueued)
        m_queued.erase(m_queued.begin() + (m_sent ? 1 : 0));
    m_queued.push_back(event);
}

/// The session takes no two of a kind within kShortestStep, so that step and time identify it.
bool IntubationWatch::isTaken(const IntubationEvent& event) const
{
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    return station != state->stations().end()
           && std::ranges::any_of(
               station->second.respiration.tube().notes(), [&](const NotedStep& note) {
                   const Duration apart = note.event.at - event.at;
                   return note.event.step == event.step && std::chrono::abs(apart) < kShortestStep;
               });
}

/// Of the session to what was proposed, once there is one, and it is shown what came of it.
void IntubationWatch::takeAnswer(SessionTime now)
{
    const auto isSent = [this](const fact::IntubationNoted& noted) {
        return noted.event == m_sent->event;
    };
    if (!m_sent || isProposed<fact::IntubationNoted>(m_node, isSent))
        return;
    if (!m_sent->answered)
        m_sent->answered = now;
    const bool wasTaken = isTaken(m_sent->event);
    if (wasTaken || now - *m_sent->answered >= kShownAfter)
        settle(*std::exchange(m_sent, std::nullopt), wasTaken);
}

void IntubationWatch::settle(const Sent& sent, bool wasTaken)
{
    const bool wasLate = !wasTaken && *sent.answered - sent.event.at > kTooLate;
    if (wasLate) {
        m_way = std::min(2 * m_way, kLongestNews);
        if (++m_late < kMostProposals)
            return;
    } else {
        m_noted[sent.event.step] = sent.event.at;
    }
    m_queued.pop_front();
    m_late = 0;
    if (m_queued.empty())
        m_way = kUsualWay;
}

/// In the order in which they were concluded, also where one has to wait, and as the session takes
/// them: no older than news are when they arrive, and at a distance from the last of the kind. With
/// the size of the tube that lies there: of the site where it is calibrated, else the patient's
/// usual one.
void IntubationWatch::propose(SessionTime now)
{
    takeAnswer(now);
    while (!m_sent && !m_queued.empty()) {
        IntubationEvent event = m_queued.front();
        event.at = std::max(event.at, now - (kLongestNews - m_way));
        const auto last = m_noted.find(event.step);
        if (last != m_noted.end())
            event.at = std::max(event.at, last->second + kShortestStep);
        if (event.at > now)
            return;
        m_sent = Sent{event};
        m_node.propose(m_station, fact::IntubationNoted{event, m_patient->tube().innerDiameter});
        takeAnswer(now);
    }
}

} // namespace carina
