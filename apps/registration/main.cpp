#include "apps/program/options/tracker_option.h"
#include "apps/program/program.h"
#include "apps/program/tracker_question.h"
#include "apps/registration/patient_landmarks.h"
#include "apps/registration/registration_journal.h"
#include "apps/registration/registration_report.h"
#include "apps/registration/scripted_hand.h"
#include "apps/registration/scripted_technician.h"
#include "apps/registration/workplace.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/site_file.h"
#include "ui/registration/registration_window.h"
#include "ui/tracker/recording_end.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLockFile>
#include <QStandardPaths>

#include <cstdio>
#include <utility>

namespace carina
{
namespace
{

const QString kSite = QStringLiteral("site");
const QString kHands = QStringLiteral("hands");
const QString kScripted = QStringLiteral("scripted");
const QString kMeasure = QStringLiteral("measure");
const QString kJournal = QStringLiteral("journal");

QString words(const char* text) { return QApplication::translate("Registration", text); }

QString defaultSite()
{
    return QDir{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)}.filePath(
        QStringLiteral("site.json"));
}

/// "~/.local/share/carina/carina-registration/site.json": short enough for a line of help.
QString shownSite()
{
    const QString home = QDir::homePath() + QLatin1Char{'/'};
    const QString file = defaultSite();
    return QDir::toNativeSeparators(
        file.startsWith(home) ? QStringLiteral("~/") + file.mid(home.size()) : file);
}

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        words("Registers a patient's anatomy to a manikin by touched landmarks."));
    parser.addOption(
        {kSite,
         words("File of the site, saved after every step; a stored site is continued. Without "
               "this option %1.")
             .arg(shownSite()),
         QStringLiteral("FILE"), defaultSite()});
    parser.addOption({kHands,
                      words("Hand that holds the stylus of the simulated tracker: scripted does "
                            "what the wizard asks for; off leaves the stylus where it is."),
                      QStringLiteral("WHO"), kScripted});
    parser.addOption({kMeasure,
                      words("Go through all steps without a person, write pictures of the pages, "
                            "registration.json and registration.pdf into this folder, which is "
                            "created if missing, and exit."),
                      QStringLiteral("DIR")});
    parser.addOption({kJournal, words("Append a line to this file whenever what is shown changes."),
                      QStringLiteral("FILE")});
    program::addTrackerOption(
        parser, words("Without it the devices are used that the site names; where it names "
                      "none, a window asks for the tracker."));
    program::addSizeOption(parser);
    program::addPatientOptions(parser);
}

Result<void> writeReport(const QDir& folder, const std::string& siteFile,
                         const AirwayLandmarks& airway, const SimulatedWorkplace& workplace)
{
    const auto stored = readSiteFile(siteFile);
    if (!stored)
        return tl::unexpected(stored.error());
    const QByteArray report =
        QJsonDocument{registrationReport(*stored, airway, workplace)}.toJson();
    return writeWholeFile(folder.filePath(QStringLiteral("registration.json")).toStdString(),
                          report.toStdString());
}

/// Lets the scripted technician work and reports what came of it.
int measure(RegistrationWindow& window, const RegistrationModel& registration,
            const SimulatedWorkplace& workplace, const QCommandLineParser& parser)
{
    const QDir folder{parser.value(kMeasure)};
    ScriptedTechnician technician{window, registration, folder};
    QObject::connect(&technician, &ScriptedTechnician::done, &window, [&] {
        auto wrote = writeReport(folder, parser.value(kSite).toStdString(),
                                 registration.patient().landmarks(), workplace);
        if (wrote)
            wrote = window.writeReport(folder.filePath(QStringLiteral("registration.pdf")));
        QApplication::exit(wrote ? 0 : program::refuse(wrote.error()));
    });
    QObject::connect(&technician, &ScriptedTechnician::stuck, &window, [](const QString& where) {
        std::fprintf(stderr, "%s\n",
                     qPrintable(words("The registration did not get done: %1").arg(where)));
        QApplication::exit(1);
    });
    return QApplication::exec();
}

/// The journal that `--journal` asks for; null without it.
Result<std::unique_ptr<RegistrationJournal>> journalOf(const RegistrationModel& registration,
                                                       const QCommandLineParser& parser)
{
    if (!parser.isSet(kJournal))
        return nullptr;
    return RegistrationJournal::open(parser.value(kJournal), registration);
}

/// What the wizard's window ends with where another tracker is to be used, or the site's devices.
constexpr int kAnotherTracker = 100;
constexpr int kSiteDevices = 101;

/// What one window leaves to the next one, with another tracker.
struct Passed {
    TrackerChoice tracker;
    bool isOfSite = false;    ///< made of the devices that the site names
    std::vector<Site> past{}; ///< for undo
    QByteArray geometry{};    ///< of the window; empty before the first
};

/// The recording of the poses, which goes on through one tracker after another.
struct Record {
    PoseRecording poses{workplaceNow};
    QString wanted{}; ///< the file of `--record`; empty once it has begun

    ~Record() { finishRecording(poses); }
};

/// Records the tools of a workplace while both are there.
class RecordedWorkplace
{
public:
    RecordedWorkplace(Record& record, const Workplace& workplace) : m_record{record}
    {
        m_record.poses.follow(workplace.tracker().tools(), {});
    }
    ~RecordedWorkplace() { m_record.poses.follow({}, {}); }
    RecordedWorkplace(const RecordedWorkplace&) = delete;
    RecordedWorkplace& operator=(const RecordedWorkplace&) = delete;

    /// Begins what `--record` asks for, once.
    [[nodiscard]] Result<void> begin()
    {
        const QString file = std::exchange(m_record.wanted, {});
        return file.isEmpty() ? Result<void>{} : m_record.poses.begin(file);
    }

private:
    Record& m_record;
};

/// Has a tracker deliver, or give its devices free.
std::function<Result<void>(bool)> switchOf(Tracker& tracker)
{
    return [&tracker](bool tracks) -> Result<void> {
        if (tracks)
            return tracker.start();
        tracker.stop();
        return {};
    };
}

/// The wizard with this tracker, until its window is closed.
Result<int> work(const QCommandLineParser& parser, const program::ChosenPatient& patient,
                 Passed& passed, Record& record)
{
    const TrackerChoice& tracker = passed.tracker;
    const std::string siteFile = parser.value(kSite).toStdString();
    auto site = RegistrationModel::siteOf(siteFile, *patient.model);
    if (!site)
        return tl::unexpected(site.error());
    if (auto writable = writeSiteFile(siteFile, *site); !writable)
        return tl::unexpected(writable.error());
    const auto workplace = workplaceWith(tracker, patient);
    if (!workplace)
        return tl::unexpected(workplace.error());
    if (auto started = workplace->tracker().start(); !started)
        return tl::unexpected(started.error());

    RegistrationModel registration{
        {.file = siteFile,
         .tracker = &workplace->tracker(),
         .trackerName = workplace->name,
         .clock = workplace->clock,
         .landmarks = landmarkSetsOf(patient),
         .checks = checkPlacesOf(patient),
         .usualVolume = usualVolume(tracker),
         .trackedDevices = passed.isOfSite ? std::optional{site->devices} : std::nullopt,
         .track = switchOf(workplace->tracker()),
         .past = std::move(passed.past)},
        std::move(*site),
        *patient.model};
    const auto journal = journalOf(registration, parser);
    if (!journal)
        return tl::unexpected(journal.error());
    std::optional<ScriptedHand> hand;
    if (workplace->simulated && parser.value(kHands) == kScripted)
        hand.emplace(registration, *workplace->simulated);
    RecordedWorkplace recorded{record, *workplace};
    if (const auto begun = recorded.begin(); !begun)
        return tl::unexpected(begun.error());
    RegistrationWindow window{registration, record.poses};
    QObject::connect(&window, &RegistrationWindow::anotherTrackerWanted, &window,
                     [] { QApplication::exit(kAnotherTracker); });
    QObject::connect(&window, &RegistrationWindow::siteDevicesWanted, &window,
                     [] { QApplication::exit(kSiteDevices); });
    if (!window.restoreGeometry(passed.geometry))
        window.resize(*program::sizeOption(parser));
    window.show();
    const int ended = parser.isSet(kMeasure)
                          ? measure(window, registration, *workplace->simulated, parser)
                          : QApplication::exec();
    passed.past = registration.past();
    passed.geometry = window.saveGeometry();
    return ended;
}

/// The tracker that a person chooses; nothing where they choose none.
Result<std::optional<TrackerChoice>> chosenTracker(const QCommandLineParser& parser)
{
    const QFileInfo site{parser.value(kSite)};
    const QString kept = site.absoluteDir().filePath(QStringLiteral("tracker.json"));
    return program::askForTracker(kept.toStdString(), program::recordDeviceOption(parser));
}

/// Goes on with the devices that the site names; with the present tracker where it names none that
/// can be used.
void passSiteDevices(Passed& passed, const QCommandLineParser& parser)
{
    auto devices = trackerOfSite(parser.value(kSite).toStdString());
    passed.isOfSite = devices && *devices;
    if (!passed.isOfSite)
        return;
    passed.tracker = **std::move(devices);
    passed.tracker.conversation = program::recordDeviceOption(parser);
}

/// The wizard with one tracker after another.
Result<int> workOn(const QCommandLineParser& parser, const program::ChosenPatient& patient,
                   Passed passed)
{
    Record record{.wanted = program::recordOption(parser)};
    for (;;) {
        const auto ended = work(parser, patient, passed, record);
        if (ended && *ended == kSiteDevices) {
            passSiteDevices(passed, parser);
        } else if (ended && *ended == kAnotherTracker) {
            auto chosen = chosenTracker(parser);
            if (!chosen)
                return tl::unexpected(chosen.error());
            if (*chosen) {
                passed.tracker = **std::move(chosen);
                passed.isOfSite = false;
            }
        } else {
            return ended;
        }
    }
}

/// Asks for a tracker where there is none, and works with it at the site.
Result<int> show(const QCommandLineParser& parser, const program::ChosenPatient& patient,
                 std::optional<TrackerChoice> tracker)
{
    const std::string siteFile = parser.value(kSite).toStdString();
    if (!QDir{}.mkpath(QFileInfo{parser.value(kSite)}.absolutePath()))
        return fail(Errc::FileUnwritable, siteFile);
    QLockFile lock{parser.value(kSite) + QStringLiteral(".lock")};
    lock.setStaleLockTime(0); // it is stale when its program is gone
    if (!lock.tryLock())
        return fail(lock.error() == QLockFile::LockFailedError ? Errc::SiteInUse
                                                               : Errc::FileUnwritable,
                    siteFile);
    const bool isOfSite =
        tracker && (!program::namesTracker(parser) || program::namesSiteDevices(parser));
    if (!tracker) {
        auto chosen = chosenTracker(parser);
        if (!chosen)
            return tl::unexpected(chosen.error());
        tracker = *std::move(chosen);
    }
    return tracker ? workOn(parser, patient, {*std::move(tracker), isOfSite}) : Result<int>{0};
}

/// Whether the options can be used together, and folders be written to.
Result<void> checkOptions(const QCommandLineParser& parser,
                          const std::optional<TrackerChoice>& tracker)
{
    if (const auto size = program::sizeOption(parser); !size)
        return tl::unexpected(size.error());
    if (const QString who = parser.value(kHands); who != kScripted && who != QStringLiteral("off"))
        return fail(Errc::WrongOption,
                    "--hands takes scripted or off, not '" + who.toStdString() + "'");
    if (!parser.isSet(kMeasure))
        return {};
    if (!tracker || !tracker->isSimulated())
        return fail(Errc::WrongOption, "--measure needs --tracker simulated");
    return openFolder(parser.value(kMeasure).toStdString());
}

Result<int> run(const QCommandLineParser& parser)
{
    auto tracker = program::readTrackerOption(parser, parser.value(kSite));
    if (!tracker)
        return tl::unexpected(tracker.error());
    if (const auto checked = checkOptions(parser, *tracker); !checked)
        return tl::unexpected(checked.error());
    if (const auto drawn = program::checkGraphics(); !drawn)
        return tl::unexpected(drawn.error());
    const auto patient = program::choosePatient(parser);
    if (!patient)
        return tl::unexpected(patient.error());
    return show(parser, *patient, *std::move(tracker));
}

} // namespace
} // namespace carina

int main(int argc, char** argv)
{
    return carina::program::runProgram({.name = QStringLiteral("carina-registration"),
                                        .addOptions = carina::addOptions,
                                        .run = carina::run},
                                       argc, argv);
}
