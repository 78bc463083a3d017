#include "apps/instructor/scripted_console.h"
#include "apps/instructor/shown_station.h"
#include "apps/program/control_script.h"
#include "apps/program/entry_option.h"
#include "apps/program/journal.h"
#include "apps/program/measurement.h"
#include "apps/program/openigtlink_option.h"
#include "apps/program/patient_option.h"
#include "apps/program/program.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/net/discovery/session_beacon.h"
#include "engine/net/entry/session_identity.h"
#include "engine/session/station_rules.h"
#include "engine/sync/strategies/strategy.h"
#include "models/objects/liftables.h"
#include "models/patient/new_patient.h"
#include "models/patient/shared_patient.h"
#include "models/respiration/checkpoint_keeper.h"
#include "ui/instructor/instructor_window.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QStandardPaths>
#include <QTimer>

namespace carina
{
namespace
{

const QString kCertificate = QStringLiteral("certificate");
const QString kStrategy = QStringLiteral("strategy");
const QString kAddStation = QStringLiteral("add-station");
const QString kPrivateKey = QStringLiteral("private-key");

QString words(const char* text) { return QApplication::translate("Instructor", text); }

QStringList strategyNames()
{
    QStringList names;
    for (const SyncStrategy& strategy : syncStrategies())
        names += QString::fromUtf8(strategy.name.data(), qsizetype(strategy.name.size()));
    return names;
}

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(words("The instructor's console, which hosts the session."));
    parser.addOption({QStringLiteral("port"),
                      words("UDP and TCP port of the session; 0 takes a free one."),
                      QStringLiteral("P"), QStringLiteral("0")});
    parser.addOption({QStringLiteral("data"), words("Folder that the session is stored in."),
                      QStringLiteral("DIR"),
                      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)});
    parser.addOption({QStringLiteral("new"),
                      words("Begin a new session; the stored one is kept. Without this option the "
                            "stored session is continued, unless it has ended.")});
    parser.addOption(
        {QStringLiteral("open"), words("Let programs on other computers join too; without this "
                                       "option only those on this computer can.")});
    parser.addOption({kCertificate,
                      words("Authenticate this host by the certificate in this file (PEM), "
                            "followed by the intermediate certificates of its authority."),
                      QStringLiteral("FILE")});
    parser.addOption({kPrivateKey, words("The key of the certificate (PEM, without a password)."),
                      QStringLiteral("FILE")});
    parser.addOption({QStringLiteral("codes"),
                      words("Write the codes to join with into this file, for scripts."),
                      QStringLiteral("FILE")});
    parser.addOption({QStringLiteral("start"), words("Start a session that is ready to start.")});
    program::addScriptOption(parser);
    parser.addOption({kStrategy,
                      words("Keep what is acted on alike by this strategy: %1. Without this option "
                            "as before, in a new session by %2.")
                          .arg(strategyNames().join(QStringLiteral(", ")), strategyNames().first()),
                      QStringLiteral("NAME")});
    parser.addOption({kAddStation,
                      words("Open a station of this name, unless there is one; with a patient as "
                            "for --patient after a colon, such as \"Room 5: adult\". May be given "
                            "several times."),
                      QStringLiteral("NAME")});
    program::addOpenIgtLinkOption(parser);
    program::addPatientOptions(parser);
    program::addMeasureOptions(parser);
    program::addJournalOption(parser);
}

/// Each session has a file of its own, named by the time it began, and is never moved.
QString newSessionFile(const QDir& folder)
{
    const QString began =
        QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-hhmmss-zzz"));
    return folder.filePath(QStringLiteral("session-%1.sqlite").arg(began));
}

/// Its codes, keys and tokens lie beside it.
std::filesystem::path secretsOf(const QString& sessionFile)
{
    return std::filesystem::path{sessionFile.toStdString()}.replace_extension(".secrets");
}

/// The session that began last; a new one where there is none.
QString latestSessionFile(const QDir& folder)
{
    const QStringList all =
        folder.entryList({QStringLiteral("session-*.sqlite")}, QDir::Files, QDir::Name);
    return all.isEmpty() ? newSessionFile(folder) : folder.filePath(all.last());
}

/// Tells the session which patient lies at its first station and how it breathes at rest, unless it
/// has one and no other is asked for, and makes it something to act on; and what can be lifted out
/// at the stations.
void introduceFirst(SessionNode& node, const program::ChosenPatient& patient, bool isAskedFor)
{
    const StationId first = firstOpenStation(*node.state());
    const std::string present = node.state()->stations().at(first).anatomyHash;
    if (present.empty() || (isAskedFor && present != patient.model->contentHash()))
        introducePatient(node, first, patient.model->contentHash(), patient.model->name(),
                         patient.dimensions);
    sharePatient(node, first, words("Virtual patient").toStdString());
    const auto state = node.state();
    for (const auto& [id, station] : state->stations())
        if (!station.closed)
            shareLiftables(node, id); // which a session from before they existed lacks
}

/// A station of `--add-station`.
struct WantedStation {
    QString name;
    QString patient;
};

Result<std::vector<WantedStation>> wantedStations(const QCommandLineParser& parser)
{
    std::vector<WantedStation> wanted;
    for (const QString& value : parser.values(kAddStation)) {
        const QString name = value.section(QLatin1Char(':'), 0, 0).trimmed();
        const QString patient = value.section(QLatin1Char(':'), 1).trimmed();
        wanted.push_back({name, patient.isEmpty() ? QStringLiteral("child") : patient});
        const auto figures = patientFromWords(wanted.back().patient.toStdString());
        if (name.isEmpty() || !figures)
            return fail(Errc::WrongOption,
                        "--add-station: "
                            + (figures ? value.toStdString() : figures.error().detail));
    }
    return wanted;
}

void openStations(const SessionNode& node, StationsModel& stations,
                  const std::vector<WantedStation>& wanted)
{
    for (const auto& [name, patient] : wanted)
        if (!openStationNamed(*node.state(), name.toStdString()))
            stations.add(name, patient, StationsModel::After::StayHere);
}

/// Measures the window while a script works its controls, then leaves.
int measure(InstructorWindow& window, SessionNode& node, BreathingModel& breathing,
            const program::MeasureOptions& options)
{
    program::Measurement measurement{window, window.stationScene()};
    ScriptedConsole script{window, node, breathing};
    QTimer::singleShot(options.seconds * 1000, [&] {
        const auto wrote = measurement.write(QDir{options.folder}, QStringLiteral("instructor"),
                                             {{QStringLiteral("console"), script.report()}});
        QApplication::exit(wrote ? 0 : program::refuse(wrote.error()));
    });
    return QApplication::exec();
}

/// How the session is reached, and by whom.
struct Reach {
    std::uint16_t port = 0;
    bool open = false;
    std::optional<CertificateFiles> certificate{};
    std::optional<StrategyKind> strategy{};
    std::filesystem::path anatomyCache{}; ///< that the patient is in, if it was imported
};

Result<Reach> reachOptions(const QCommandLineParser& parser)
{
    const auto port = program::portOption(parser);
    if (!port)
        return tl::unexpected(port.error());
    Reach reach{.port = *port, .open = parser.isSet(QStringLiteral("open"))};
    if (parser.isSet(kStrategy)) {
        const SyncStrategy* strategy = findSyncStrategy(parser.value(kStrategy).toStdString());
        if (!strategy)
            return fail(Errc::WrongOption,
                        "--strategy takes one of "
                            + strategyNames().join(QStringLiteral(", ")).toStdString());
        reach.strategy = strategy->kind;
    }
    if (program::importsPatient(parser))
        reach.anatomyCache = AnatomyCache::defaultFolder();
    if (parser.isSet(kCertificate) != parser.isSet(kPrivateKey))
        return fail(Errc::WrongOption, "--certificate and --private-key need each other");
    if (parser.isSet(kCertificate))
        reach.certificate = CertificateFiles{parser.value(kCertificate).toStdString(),
                                             parser.value(kPrivateKey).toStdString()};
    return reach;
}

Result<std::unique_ptr<SessionNode>> hostFile(const QString& file, const Reach& reach)
{
    auto store = openFactStore(file.toStdString());
    if (!store)
        return tl::unexpected(store.error());
    return SessionNode::host({.sessionName = words("Routine intubation").toStdString(),
                              .participantName = words("Instructor").toStdString(),
                              .port = reach.port,
                              .open = reach.open,
                              .strategy = reach.strategy,
                              .secrets = secretsOf(file),
                              .certificate = reach.certificate,
                              .anatomyCache = reach.anatomyCache},
                             std::move(*store));
}

bool hasEnded(const SessionNode& node)
{
    const auto now = node.now();
    return now && node.state()->phaseAt(*now) == SessionPhase::Ended;
}

/// Whether a person can be asked to begin anew, because what is stored cannot be read.
bool mayBeginAnew(const Error& error)
{
    return program::isSeenOnly()
           && (error.code == Errc::StoreCorrupt || error.code == Errc::StoreTooOld
               || error.code == Errc::UnknownFormat || error.code == Errc::FileMalformed);
}

/// The stored session, or a new one where that was asked for, nothing is stored, or what is stored
/// has ended, or cannot be read and a person wants to begin anew; it stays where it is.
/// @returns Cancelled where the person does not.
Result<std::unique_ptr<SessionNode>> hostSession(const QCommandLineParser& parser,
                                                 const Reach& reach)
{
    const QDir folder{parser.value(QStringLiteral("data"))};
    if (!folder.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, folder.path().toStdString());
    if (parser.isSet(QStringLiteral("new")))
        return hostFile(newSessionFile(folder), reach);
    auto node = hostFile(latestSessionFile(folder), reach);
    if (node ? !hasEnded(**node) : !mayBeginAnew(node.error()))
        return node;
    if (!node && !program::askInstead(node.error(), words("Start a new session")))
        return fail(Errc::Cancelled);
    if (node)
        node->reset(); // gives the port back
    return hostFile(newSessionFile(folder), reach);
}

/// Lets those who look for sessions find this one.
Result<std::unique_ptr<SessionBeacon>> beaconOf(const SessionNode& node)
{
    const auto state = node.state();
    return SessionBeacon::open({sessionKey(state->sessionId()), state->name(), node.port()},
                               node.isOpen());
}

Result<int> run(const QCommandLineParser& parser)
{
    const auto options = program::measureOptions(parser);
    if (!options)
        return tl::unexpected(options.error());
    const auto reach = reachOptions(parser);
    if (!reach)
        return tl::unexpected(reach.error());
    if (const auto drawn = program::checkGraphics(); !drawn)
        return tl::unexpected(drawn.error());
    const auto wanted = wantedStations(parser);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto patient = program::choosePatient(parser);
    if (!patient)
        return tl::unexpected(patient.error());
    const auto node = hostSession(parser, *reach);
    if (!node)
        return tl::unexpected(node.error());
    const auto beacon = beaconOf(**node);
    if (!beacon)
        program::warn(beacon.error());
    introduceFirst(**node, *patient, program::namesPatient(parser));
    if (const QString codes = parser.value(QStringLiteral("codes")); !codes.isEmpty())
        if (const auto written = program::writeCodes(codes, (*node)->joinCodes()); !written)
            return tl::unexpected(written.error());

    SessionModel session{**node};
    StationsModel stations{session};
    const StationId first = stations.shown();
    BreathingModel breathing{session, first};
    ParticipantsModel participants{session};
    ConductModel conduct{session};
    PeopleModel people{session, first};
    NetworkModel network{session};
    SharedObjectModel object{session, first};
    ObjectActionModel actions{object};
    RespirationModel respiration{session, first};
    BreathTrace trace{session, first};
    const CheckpointKeeper checkpoints{**node};
    ShownStation shown{**node, first, patient->model};
    InstructorWindow window{session,      breathing, respiration,     trace,
                            participants, conduct,   people,          network,
                            actions,      stations,  shown.patient(), shown.view()};
    shown.onShown(
        [&window](const PatientModel& another, StationView& view) { window.show(another, view); });
    window.resize(options->size);
    window.show();
    window.resize(options->size); // before it is shown, its least size is larger than it has to be
    const auto journal = program::journalFromOptions(parser, **node, first, window.stationScene());
    if (!journal)
        return tl::unexpected(journal.error());
    QObject::connect(&stations, &StationsModel::shownChanged, &stations, [&](StationId now) {
        breathing.setStation(now);
        object.setStation(now);
        people.setStation(now);
        respiration.setStation(now);
        trace.setStation(now);
        shown.setStation(now);
        if (*journal)
            (*journal)->setStation(now);
    });
    QObject::connect(&stations, &StationsModel::forAllChanged, &stations, [&](bool all) {
        breathing.setForAll(all);
        respiration.setForAll(all);
    });
    const auto giver = program::openIgtLinkOption(parser, window, [&shown] {
        return OfferGiver::Shown{shown.view(), *shown.patient().patient()};
    });
    if (!giver)
        return tl::unexpected(giver.error());
    openStations(**node, stations, *wanted);
    if (parser.isSet(QStringLiteral("start")) && session.canStart())
        session.start();
    const auto script = program::scriptFromOptions(parser, window);
    return options->folder.isEmpty() ? QApplication::exec()
                                     : measure(window, **node, breathing, *options);
}

} // namespace
} // namespace carina

int main(int argc, char** argv)
{
    return carina::program::runProgram({.name = QStringLiteral("carina-instructor"),
                                        .addOptions = carina::addOptions,
                                        .run = carina::run},
                                       argc, argv);
}
