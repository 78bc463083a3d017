#include "apps/program/journal.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/files/private_file.h"
#include "models/patient/shared_patient.h"
#include "models/site/standing_words.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <utility>

namespace carina::program
{
namespace
{

constexpr int kInterval_ms = 100;
const QString kJournal = QStringLiteral("journal");

QString phaseName(SessionPhase phase)
{
    switch (phase) {
    case SessionPhase::Prepared:
        return QStringLiteral("prepared");
    case SessionPhase::Running:
        return QStringLiteral("running");
    case SessionPhase::Paused:
        return QStringLiteral("paused");
    case SessionPhase::Ended:
        return QStringLiteral("ended");
    }
    return {};
}

/// What the participants who are present stated of their registrations, by name.
QJsonObject registrations(const SessionState& state)
{
    QJsonObject stated;
    for (const auto& [id, participant] : state.participants())
        if (participant.present && participant.registration)
            stated[QString::fromStdString(participant.name)] =
                standingText(*participant.registration);
    return stated;
}

QJsonArray placeInMillimetres(const Vec3& p)
{
    const Vec3 p_mm = 1e3 * p;
    return {p_mm.x(), p_mm.y(), p_mm.z()};
}

void addPatient(QJsonObject& line, const StationMoment& moment, const SharedObject* patient)
{
    if (patient)
        line[QStringLiteral("patient_owner")] = patient->owner.value;
    if (!moment.patient)
        return;
    const ActedPose& acted = moment.patient->acted;
    const Quat& q = acted.X_AO.rotation();
    line[QStringLiteral("patient_rate")] = moment.patient->rate;
    line[QStringLiteral("patient_xyz_mm")] = placeInMillimetres(acted.X_AO.translation());
    line[QStringLiteral("patient_q_xyzw")] = QJsonArray{q.x(), q.y(), q.z(), q.w()};
    line[QStringLiteral("patient_size")] = acted.scale;
}

QJsonArray turnOf(const RigidTransform& X)
{
    const Quat& q = X.rotation();
    return {q.x(), q.y(), q.z(), q.w()};
}

QJsonArray liftedOf(const SceneFrame& frame, const StationMoment& moment)
{
    QJsonArray all;
    for (const LiftedInFrame& lifted : liftedIn(frame, moment))
        all.append(QJsonObject{
            {QStringLiteral("object"), lifted.object.value},
            {QStringLiteral("owner"), lifted.owner.value},
            {QStringLiteral("group"),
             QString::fromLatin1(lifted.group ? groupName(*lifted.group) : "")},
            {QStringLiteral("xyz_mm"), placeInMillimetres(lifted.place.X_AF.translation())},
            {QStringLiteral("q_xyzw"), turnOf(lifted.place.X_AF)},
            {QStringLiteral("size"), lifted.place.scale}});
    return all;
}

QJsonObject frameOf(const DrawnFrame& drawn, const StationMoment& moment)
{
    QJsonArray objects;
    for (const ObjectInFrame& object : objectsIn(drawn.frame, moment)) {
        objects.append(
            QJsonObject{{QStringLiteral("object"), object.object.value},
                        {QStringLiteral("owner"), object.owner.value},
                        {QStringLiteral("kind"), int(object.kind)},
                        {QStringLiteral("own"), object.isOwn},
                        {QStringLiteral("xyz_mm"), placeInMillimetres(object.X_AO.translation())},
                        {QStringLiteral("q_xyzw"), turnOf(object.X_AO)}});
    }
    return {{QStringLiteral("session_ns"), qint64(moment.time.time_since_epoch().count())},
            {QStringLiteral("objects"), objects},
            {QStringLiteral("lifted"), liftedOf(drawn.frame, moment)}};
}

/// The severities of what makes the airway difficult, by name.
QJsonObject severitiesOf(const AirwayEvents& events)
{
    QJsonObject severities;
    for (const AirwayEvent& event : events)
        severities[QLatin1String{eventName(event.kind)}] = event.severity;
    return severities;
}

/// As it is drawn.
QJsonObject anglesOf(const HeadPosition& position)
{
    return {{QStringLiteral("neck_flexion_deg"), inDegrees(position.flexion)},
            {QStringLiteral("head_extension_deg"), inDegrees(position.extension)}};
}

/// Who has what can be lifted out at a station.
QJsonObject holders(const SessionState& state, StationId station)
{
    QJsonObject all;
    for (const auto& [id, object] : state.objects())
        if (object.station == station && isLiftable(object.kind) && object.owner != kNobody)
            all[QString::fromStdString(object.name)] = object.owner.value;
    return all;
}

} // namespace

Journal::Journal(const SessionNode& node, StationId station, StationScene& scene, Notice notice,
                 VideoSince videoSince)
    : m_node{node},
      m_station{station},
      m_scene{scene},
      m_notice{std::move(notice)},
      m_videoSince{std::move(videoSince)}
{
    scene.onFrameDrawn(
        [kept = std::weak_ptr{m_frames}](const DrawnFrame& drawn, const StationMoment& moment) {
            if (const auto frames = kept.lock(); frames && moment.time != SessionTime{})
                frames->append(frameOf(drawn, moment));
        });
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { writeLine(); });
}

Result<std::unique_ptr<Journal>> Journal::open(const QString& path, const SessionNode& node,
                                               StationId station, StationScene& scene,
                                               Notice notice, VideoSince videoSince)
{
    std::unique_ptr<Journal> journal{
        new Journal{node, station, scene, std::move(notice), std::move(videoSince)}};
    journal->m_file.setFileName(path);
    // It holds people's names.
    if (!openPrivately(journal->m_file, QIODevice::WriteOnly | QIODevice::Append))
        return fail(Errc::FileUnwritable, path.toStdString());
    journal->m_timer.start(kInterval_ms);
    return journal;
}

void Journal::writeLine()
{
    const SessionTime shown = m_scene.moment().time;
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (shown == SessionTime{} || station == state->stations().end()) {
        *m_frames = {};
        return; // nothing of a session is on the screen yet
    }
    const BreathingPattern pattern = station->second.respiration.settingsAt(shown).pattern;
    const auto& lungs = m_scene.moment().breathing.lungs;
    const auto nanoseconds = [](auto time) { return qint64(time.time_since_epoch().count()); };
    // The frame's session time, told on the clock that all processes of this machine share.
    const SessionTime now = m_node.now().value_or(shown);
    QJsonObject line{
        {QStringLiteral("local_ns"), nanoseconds(machineTime(monotonicNow() - (now - shown)))},
        {QStringLiteral("session_ns"), nanoseconds(shown)},
        {QStringLiteral("facts"), qint64(state->lastApplied().value)},
        {QStringLiteral("session_id"), QString::fromStdString(state->sessionId())},
        {QStringLiteral("station"), QString::fromStdString(station->second.name)},
        {QStringLiteral("anatomy"), QString::fromStdString(m_scene.patient().contentHash())},
        {QStringLiteral("phase"), phaseName(state->phaseAt(shown))},
        {QStringLiteral("breathing_rate_per_min"), inPerMinute(pattern.rate)},
        {QStringLiteral("tidal_volume_ml"), inMillilitres(pattern.tidalVolume)},
        {QStringLiteral("right_lung_ml"), inMillilitres(lungs[0].gas)},
        {QStringLiteral("left_lung_ml"), inMillilitres(lungs[1].gas)},
        {QStringLiteral("frames"), std::exchange(*m_frames, QJsonArray{})}};
    line[QStringLiteral("registrations")] = registrations(*state);
    line[QStringLiteral("airway_events")] = severitiesOf(m_scene.moment().airwayEvents);
    line[QStringLiteral("head_position")] = anglesOf(m_scene.moment().headPosition);
    line[QStringLiteral("holders")] = holders(*state, m_station);
    if (m_notice)
        line[QStringLiteral("notice")] = m_notice();
    if (const auto since = m_videoSince ? m_videoSince() : std::nullopt)
        line[QStringLiteral("video_since_ns")] = nanoseconds(*since);
    addPatient(line, m_scene.moment(), sharedPatient(*state, m_station));
    m_file.write(QJsonDocument{line}.toJson(QJsonDocument::Compact) + '\n');
    m_file.flush();
}

void addJournalOption(QCommandLineParser& parser)
{
    parser.addOption({kJournal,
                      QCoreApplication::translate("Program", "Append a line of what is shown to "
                                                             "this file ten times a second."),
                      QStringLiteral("FILE")});
}

Result<std::unique_ptr<Journal>> journalFromOptions(const QCommandLineParser& parser,
                                                    const SessionNode& node, StationId station,
                                                    StationScene& scene, Journal::Notice notice,
                                                    Journal::VideoSince videoSince)
{
    if (!parser.isSet(kJournal))
        return nullptr;
    return Journal::open(parser.value(kJournal), node, station, scene, std::move(notice),
                         std::move(videoSince));
}

} // namespace carina::program
