#include "models/scoring/try_watch.h"

#include "models/session/proposed.h"

#include <QTimer>

#include <algorithm>
#include <ratio>
#include <utility>

namespace carina
{
namespace
{

constexpr int kWatchInterval_ms = 50;
using VitalsGrid = std::chrono::duration<std::int64_t, std::ratio<1, 5>>;
static_assert(VitalsGrid{1} == TryWatch::kVitalsEvery);

/// Against gravity, in A: to the front of a patient who lies supine.
Vec3 upInAnatomy() { return -Vec3::UnitY(); }

/// Of what a program that comes later knows no more, as it was first.
TubedPatient tubedPatient(const Station& station, SessionTime t)
{
    t = std::max(t, station.respiration.keptFrom());
    const PatientBuild build = station.respiration.settingsAt(t).build;
    return {build.height, build.ageInYears, build.sex == Sex::Female,
            station.respiration.tubePlaceAt(t).innerDiameter};
}

const PersonPose* laryngoscopeOf(const std::vector<PersonPose>& people, ParticipantId worker)
{
    const auto found = std::ranges::find_if(people, [worker](const PersonPose& person) {
        return person.kind == ObjectKind::Laryngoscope && person.owner == worker;
    });
    return found == people.end() ? nullptr : &*found;
}

} // namespace

TryWatch::TryWatch(SessionModel& session, StationId station, ObjectPoses own, QObject* parent)
    : QObject{parent},
      m_session{session},
      m_station{station},
      m_own{std::move(own)},
      m_course{upInAnatomy()}
{
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &TryWatch::watch);
    timer->start(kWatchInterval_ms);
}

void TryWatch::setStation(StationId station)
{
    if (std::exchange(m_station, station) == station)
        return;
    m_course = TryCourse{upInAnatomy()};
    m_told.reset();
    m_toldUntil = SessionTime::min();
    m_latest = {};
    m_patient = {};
    m_report.reset();
    m_judged.reset();
    m_lastNote = 0;
    m_maskVentilated.reset();
    m_watchedSince.reset();
    Q_EMIT changed();
}

const Station* TryWatch::stationIn(const SessionState& state) const
{
    const auto found = state.stations().find(m_station);
    return found == state.stations().end() ? nullptr : &found->second;
}

Duration TryWatch::time() const
{
    const auto now = m_session.node().now();
    return isUnderWay() && now ? m_session.node().state()->pauses().between(m_begun, *now)
                               : Duration{};
}

void TryWatch::watch()
{
    const auto now = m_session.node().now();
    const auto state = m_session.node().state();
    const Station* station = stationIn(*state);
    if (!now || !station)
        return;
    const bool isFirstLook = !m_watchedSince;
    if (isFirstLook)
        m_watchedSince = now;
    m_course.setPauses(state->pauses());
    takeFacts(*state, *station);
    if (isFirstLook) // when it was inflated is noted
        m_isCuffInflated = station->respiration.tube().cuffInflatedAt(*now);
    if (!isUnderWay())
        return lookAtMask(*station, *now);
    takeCuff(*state, *now);
    if (!state->pauses().contains(*now))
        takeForces(*now);
    takePoses(*state, *now);
    endBy(*state, *now);
}

/// When a person ends the try under way, or the session: also in the future.
std::optional<SessionTime> TryWatch::endedByPerson(const SessionState& state) const
{
    const auto& ends = stationIn(state)->tryEnds;
    const auto first = std::ranges::lower_bound(ends, m_begun);
    return first != ends.end() ? std::optional{*first} : state.ended();
}

/// Ends the try under way where it had ended by then, whenever this program looks.
void TryWatch::endBy(const SessionState& state, SessionTime t)
{
    if (!isUnderWay())
        return;
    takeVitals(*stationIn(state), t);
    const SessionTime asked = endedByPerson(state).value_or(SessionTime::max());
    if (const auto at = m_course.endedBy(std::min(asked, t)))
        end(*stationIn(state), *at);
    else if (asked <= t)
        end(*stationIn(state), asked);
}

/// What was noted and what was said, in the order in which it took effect. A program that looks for
/// the first time finds the last try among the facts.
void TryWatch::takeFacts(const SessionState& state, const Station& station)
{
    const TubeTimeline& tube = station.respiration.tube();
    const std::span<const NotedStep> notes = tube.notesAfter(m_lastNote);
    m_lastNote = tube.lastNote();
    auto note = notes.begin();
    for (const auto& setting : tube.overrides()) {
        if (setting.from <= m_toldUntil)
            continue;
        m_toldUntil = setting.from;
        for (; note != notes.end() && note->effect <= setting.from; ++note)
            take(state, note->event);
        tell(setting.value.seatOfNoted(), setting.from);
    }
    for (; note != notes.end(); ++note)
        take(state, note->event);
}

void TryWatch::tell(std::optional<TubeSeat> seat, SessionTime since)
{
    if (std::exchange(m_told, seat) == seat)
        return;
    m_course.tell(seat, since);
    if (isUnderWay() || !m_judged)
        return;
    m_judged->course.tell(seat, since);
    judge();
}

/// Of the try that ended last, what is known later; a tube that goes elsewhere after it is judged
/// no more. @returns whether it was of that try
bool TryWatch::takeLate(const IntubationEvent& event)
{
    if (!m_judged || isUnderWay())
        return false;
    const bool isOfIt = event.at <= m_judged->ended;
    if (isOfIt) {
        m_judged->course.add(event);
        judge();
    }
    if (event.step == IntubationStep::TubeOut || (!isOfIt && isOfWay(event.step)))
        m_judged.reset();
    return isOfIt;
}

void TryWatch::take(const SessionState& state, const IntubationEvent& event)
{
    endBy(state, event.at - Duration{1}); // an event at the end is of the try
    const double confidence = isSureOfSeat(event.step) ? event.confidence : m_latest.confidence;
    m_latest = event;
    m_latest.confidence = confidence;
    if (takeLate(event))
        return;
    const bool wasUnderWay = isUnderWay();
    if (!wasUnderWay && beginsTry(event.step)) {
        begin(*stationIn(state), event.at);
        m_course.setPauses(state.pauses());
    }
    m_course.add(event);
    if (!isUnderWay())
        return;
    if (event.step == IntubationStep::TubePastTeeth || event.step == IntubationStep::TubeOut)
        m_isTubeOut = event.step == IntubationStep::TubeOut;
    if (wasUnderWay)
        return;
    if (event.at < *m_watchedSince)
        m_course.beganBefore();
    if (m_maskVentilated && state.pauses().between(*m_maskVentilated, event.at) <= kMaskBefore)
        m_course.check(TryCheck::MaskVentilated, true);
    Q_EMIT changed();
}

void TryWatch::lookAtMask(const Station& station, SessionTime now)
{
    const RespiratorySettings settings = station.respiration.settingsAt(now);
    const bool isBlown =
        settings.bag.rate.si > 0.0 || settings.ventilator.mode != VentilationMode::Spontaneous;
    if (isBlown && station.respiration.gasAt(now).maskHeld && station.respiration.runsAt(now)
        && station.respiration.tubePlaceAt(now).seat == TubeSeat::None)
        m_maskVentilated = now;
}

void TryWatch::takeForces(SessionTime now)
{
    if (const std::optional<BladeEffort> effort = m_effort())
        m_course.addForces(now, effort->teeth, effort->contact.tongue);
}

void TryWatch::begin(const Station& station, SessionTime now)
{
    m_begun = now;
    m_isTubeOut = false;
    m_isCuffInflated = station.respiration.tube().cuffInflatedAt(now);
    m_vitalsAt = std::chrono::ceil<VitalsGrid>(now);
    m_posesAt = now;
    m_report.reset();
    m_judged.reset();
}

/// At the same moments at every program, whenever it looks: the patient follows from facts.
void TryWatch::takeVitals(const Station& station, SessionTime until)
{
    m_course.addHeadExtension(headPositionAt(station, m_begun).extension);
    const RespirationTimeline& patient = station.respiration;
    m_vitalsAt =
        std::max<SessionTime>(m_vitalsAt, std::chrono::ceil<VitalsGrid>(patient.keptFrom()));
    for (; m_vitalsAt <= until; m_vitalsAt += kVitalsEvery)
        if (patient.runsAt(m_vitalsAt))
            m_course.addVitals(m_vitalsAt, m_patient.at(patient, m_vitalsAt).vitals());
}

/// That of a tube that is out is empty without anybody's doing.
void TryWatch::takeCuff(const SessionState& state, SessionTime now)
{
    const bool isInflated = stationIn(state)->respiration.tube().cuffInflatedAt(now);
    if (std::exchange(m_isCuffInflated, isInflated) == isInflated || (m_isTubeOut && !isInflated))
        return;
    IntubationEvent cuff = m_latest;
    cuff.step = isInflated ? IntubationStep::CuffInflated : IntubationStep::CuffDeflated;
    cuff.at = now;
    take(state, cuff);
}

void TryWatch::takePoses(const SessionState& state, SessionTime now)
{
    const SessionTime until = now - kPoseDelay;
    if (!m_posesAt || until - *m_posesAt > kLongestGap)
        m_posesAt = until;
    const ParticipantId worker = state.atWork(m_station);
    const Pauses pauses = state.pauses();
    for (; *m_posesAt <= until; *m_posesAt += kPoseEvery) {
        if (pauses.contains(*m_posesAt))
            continue;
        const auto people = peoplePoses(m_session.node(), m_station, m_own, *m_posesAt);
        if (const PersonPose* blade = laryngoscopeOf(people, worker))
            m_course.addBlade(blade->pose);
        if (const PersonPose* head = headOf(people, worker))
            m_course.addHead(head->pose);
    }
}

bool TryWatch::mayFinish() const
{
    const auto state = m_session.node().state();
    const auto self = state->participants().find(m_session.node().self());
    if (!isUnderWay() || !stationIn(*state) || self == state->participants().end()
        || self->second.muted || endedByPerson(*state)
        || isProposed<fact::TryEnded>(m_session.node(), [](const auto&) { return true; }))
        return false;
    return self->second.role == Role::Instructor || state->atWork(m_station) == self->first;
}

void TryWatch::finish()
{
    if (mayFinish())
        m_session.node().propose(m_station, fact::TryEnded{});
}

void TryWatch::end(const Station& station, SessionTime at)
{
    m_judged =
        Judged{std::exchange(m_course, TryCourse{upInAnatomy()}), at, tubedPatient(station, at)};
    m_course.tell(m_told, at);
    judge();
    if (at >= *m_watchedSince)
        Q_EMIT ended();
}

void TryWatch::judge()
{
    const DepthRule rule = m_rule.value_or(usualDepthRule(m_judged->patient));
    TryMetrics metrics =
        m_judged->course.metrics(m_judged->ended, depthBy(rule, m_judged->patient));
    metrics.isViewRead = metrics.incisors.has_value(); // both by the laryngoscope's picture
    m_report = reportOf(metrics, rule, m_rubric);
    Q_EMIT changed();
}

} // namespace carina
