#include "apps/instructor/console_session.h"

#include "apps/program/options/entry_option.h"
#include "apps/program/options/openigtlink_option.h"
#include "apps/program/options/try_option.h"
#include "apps/program/site_blade.h"
#include "engine/session/station_rules.h"
#include "models/session/session_summary.h"
#include "models/vitals/stethoscope.h"
#include "ui/start/leave_question.h"
#include "ui/tracker/recording_end.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kEndInterval_ms = 100;

bool isMoving(const SessionNode& node)
{
    const auto pending = node.pending();
    return std::ranges::any_of(pending, [](const FactBody& body) {
        return std::holds_alternative<fact::ParticipantMoved>(body);
    });
}

} // namespace

ConsoleSession::ConsoleSession(HostedSession hosted, const program::ChosenPatient& patient,
                               const QString& folder, ConsoleTracker& tracker)
    : m_tracker{tracker},
      m_hosted{std::move(hosted)},
      m_tools{*m_hosted.node,
              {.tracker = tracker.choice},
              [&tracker](const PatientModel& of) { return tracker.change.placeOf(of); }},
      m_recording{[node = m_hosted.node.get()] { return node->now(); }},
      m_session{*m_hosted.node},
      m_stations{m_session},
      m_breathing{m_session, m_stations.shown()},
      m_participants{m_session},
      m_conduct{m_session},
      m_people{m_session, m_stations.shown()},
      m_network{m_session},
      m_object{m_session, m_stations.shown()},
      m_lesson{m_session, m_stations.shown()},
      m_actions{m_object},
      m_respiration{m_session, m_stations.shown()},
      m_gas{m_session, m_stations.shown()},
      m_airway{m_session, m_stations.shown()},
      m_head{m_session, m_stations.shown()},
      m_trace{m_session, m_stations.shown()},
      m_tries{m_session, m_stations.shown(), m_tools.posesOnScreen()},
      m_attention{m_session},
      m_intubation{m_session, m_stations.shown()},
      m_vitals{m_session, m_stations.shown(), KeptSounds{folder, QStringLiteral("console")}},
      m_sound{[this](std::span<float> samples) { m_vitals.model().sounds().render(samples); }},
      m_checkpoints{*m_hosted.node},
      m_shown{*m_hosted.node, m_stations.shown(), patient.model, m_lesson.poses(), m_tools},
      m_watch{*m_hosted.node, m_stations.shown(), m_tools.posesOnScreen()},
      m_offer{[this] {
          return OfferGiver::Shown{m_shown.view(), m_shown.drawn()};
      }},
      m_kept{folder},
      m_window{{m_session,      m_breathing,  m_respiration,    m_gas,
                m_airway,       m_head,       m_trace,          m_tries,
                m_participants, m_conduct,    m_people,         m_network,
                m_actions,      m_stations,   m_lesson,         m_shown.patient(),
                m_attention,    m_intubation, m_vitals.model(), m_sound},
               m_kept,
               m_shown.view(),
               program::programTracker(m_tools, m_recording, m_offer, true, folder)}
{
    m_attention.setPatient(m_shown.patient());
    m_window.setReach(m_hosted.reach);
    m_watch.readView([this] { return m_window.glottisSeen(); });
    m_watch.readStanding([this] { return m_tools.standing(); });
    m_window.stationScene().bendTubeBy(
        [this](const StationMoment& moment, const TissueAround& tissue) {
            return m_watch.tubeAt(moment, tissue);
        });
    offerTracker();
    offerStethoscope();
    m_window.onClose([this] { return mayClose(); });
    QObject::connect(&m_stations, &StationsModel::shownChanged, &m_window,
                     [this](StationId now) { setStation(now); });
    QObject::connect(&m_stations, &StationsModel::forAllChanged, &m_window, [this](bool all) {
        m_breathing.setForAll(all);
        m_respiration.setForAll(all);
        m_gas.setForAll(all);
        m_airway.setForAll(all);
        m_head.setForAll(all);
    });
}

ConsoleSession::~ConsoleSession() { m_tracker.choice = m_tools.tracker(); }

void ConsoleSession::finish() { finishRecording(m_recording); }

void ConsoleSession::offerTracker()
{
    const auto followTools = [this] {
        m_window.stationScene().showBlade(program::bladeOf(m_tools));
        m_watch.lieIn(m_shown.drawn());
        m_watch.takeOwnBlade(program::bladeOf(m_tools));
        m_tools.recordBy(m_recording);
        comeWithTools();
    };
    if (&m_shown.drawn() != m_shown.patient().patient().get())
        m_window.show(m_shown.drawn(), m_shown.view()); // with the tube of the site
    followTools();
    m_shown.onShown(
        [this](const PatientModel& another, StationView& view) { m_window.show(another, view); });
    m_tools.onReplaced(followTools);
    m_attention.setTracker([this] { return m_tools.trackerSight(); });
    m_tracker.change.watch(m_window, m_tools);
    QObject::connect(&m_window, &InstructorWindow::trackerWanted, &m_window,
                     [this] { m_tracker.change.ask(m_window, m_tools); });
    QObject::connect(&m_window, &InstructorWindow::trackerUnwanted, &m_window,
                     [this] { m_tracker.change.take(m_window, m_tools); });
}

/// Of whoever holds a stylus to the chest of the patient that is shown.
void ConsoleSession::offerStethoscope()
{
    m_vitals.setStethoscope([this, hears = std::make_shared<Stethoscope>()] {
        const StationScene& scene = m_window.stationScene();
        return hears->heard(scene.patient(), scene.moment());
    });
}

Result<std::unique_ptr<ConsoleSession>>
ConsoleSession::open(HostedSession hosted, const program::ChosenPatient& patient, bool isAskedFor,
                     const ConsoleOptions& options, ConsoleTracker& tracker,
                     const QCommandLineParser& parser)
{
    introduceFirst(*hosted.node, patient, isAskedFor);
    std::unique_ptr<ConsoleSession> session{
        new ConsoleSession{std::move(hosted), patient, options.folder, tracker}};
    if (const auto written = session->keepCodes(options.codes); !written)
        return tl::unexpected(written.error());
    session->show(options.measure.size);
    if (const auto followed = session->follow(parser); !followed)
        return tl::unexpected(followed.error());
    session->openStations(options.stations);
    if (options.played)
        session->m_assistant = std::make_unique<IntubationAssistant>(
            session->node(), session->m_stations.shown(), *options.played);
    if (options.starts && session->m_session.canStart())
        session->m_session.start();
    return session;
}

/// In a file, whenever one is replaced, too; where that cannot be written the old ones stay in it,
/// and the window shows the new.
Result<void> ConsoleSession::keepCodes(const QString& file)
{
    if (file.isEmpty())
        return {};
    QObject::connect(&m_session, &SessionModel::changed, &m_window,
                     [this, file, kept = m_hosted.node->joinCodes()]() mutable {
                         const JoinCodes now = m_hosted.node->joinCodes();
                         if (now != kept && program::writeCodes(file, now))
                             kept = now;
                     });
    return program::writeCodes(file, m_hosted.node->joinCodes());
}

void ConsoleSession::show(const QSize& size)
{
    m_window.resize(size);
    m_window.show();
    m_window.resize(size); // before it is shown, its least size is larger than it has to be
}

/// What the options want to be told of the session.
Result<void> ConsoleSession::follow(const QCommandLineParser& parser)
{
    auto journal =
        program::journalFromOptions(parser, node(), m_stations.shown(), m_window.stationScene());
    if (!journal)
        return tl::unexpected(journal.error());
    m_journal = *std::move(journal);
    if (const auto judged = program::readTryOptions(parser, m_tries); !judged)
        return judged;
    if (const auto given = program::openIgtLinkOption(parser, m_window, m_offer); !given)
        return given;
    const QString record = std::exchange(m_tracker.record, {});
    return record.isEmpty() ? Result<void>{} : m_recording.begin(record);
}

void ConsoleSession::setStation(StationId station)
{
    m_breathing.setStation(station);
    m_object.setStation(station);
    m_lesson.setStation(station);
    m_people.setStation(station);
    m_respiration.setStation(station);
    m_gas.setStation(station);
    m_airway.setStation(station);
    m_head.setStation(station);
    m_trace.setStation(station);
    m_intubation.setStation(station);
    m_watch.setStation(station);
    m_tries.setStation(station);
    m_vitals.setStation(station);
    m_shown.setStation(station);
    if (m_journal)
        m_journal->setStation(station);
    comeWithTools();
}

/// Tools are shared where their owner is: who demonstrates with them does it at the station that is
/// shown. It is no change that they would take back.
void ConsoleSession::comeWithTools()
{
    const StationId shown = m_stations.shown();
    if (m_tools.tracker() && !hasEnded() && ownStation(node()) != shown && !isMoving(node()))
        node().propose(shown, fact::ParticipantMoved{node().self()});
}

void ConsoleSession::openStations(const std::vector<WantedStation>& wanted)
{
    for (const auto& [name, patient] : wanted)
        if (!openStationNamed(*node().state(), name.toStdString()))
            m_stations.add(name, patient, StationsModel::After::StayHere);
}

void ConsoleSession::onEnded(std::function<void()> callback)
{
    if (hasEnded())
        return;
    m_onEnded = std::move(callback);
    m_looking.callOnTimeout([this] { look(); });
    m_looking.start(kEndInterval_ms);
}

bool ConsoleSession::hasEnded() const { return m_session.phase() == SessionPhase::Ended; }

void ConsoleSession::look()
{
    if (!hasEnded())
        return;
    m_looking.stop();
    m_hosted.beacon.reset(); // nobody is to find it any more
    // Not from within: the callback may destroy this.
    QMetaObject::invokeMethod(&m_window, std::exchange(m_onEnded, {}), Qt::QueuedConnection);
}

/// Without a person nobody answers.
bool ConsoleSession::mayClose()
{
    const auto now = m_hosted.node->now();
    const QString told =
        now ? leavingText(*m_hosted.node->state(), *now, m_hosted.node->self()) : QString{};
    if (told.isEmpty() || !qEnvironmentVariableIsEmpty("CARINA_UNATTENDED"))
        return true;
    const Leaving chosen = askBeforeLeaving(told, m_session.canEnd(), &m_window);
    if (chosen == Leaving::EndForAll)
        m_session.end(); // and its end page comes
    if (chosen == Leaving::ToStartPage)
        m_onLeft();
    return chosen == Leaving::CloseForNow;
}

} // namespace carina
