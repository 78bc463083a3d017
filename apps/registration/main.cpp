#include "apps/program/program.h"
#include "apps/program/site_option.h"
#include "apps/program/tracker_option.h"
#include "apps/registration/patient_landmarks.h"
#include "apps/registration/registration_journal.h"
#include "apps/registration/registration_report.h"
#include "apps/registration/scripted_hand.h"
#include "apps/registration/scripted_technician.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/site_file.h"
#include "engine/net/devices/ndi_tracker.h"
#include "ui/registration/registration_window.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLockFile>
#include <QStandardPaths>

#include <cstdio>

namespace carina
{
namespace
{

const QString kSite = QStringLiteral("site");
const QString kSimulatedTracker = QStringLiteral("simulated-tracker");
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

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        words("Registers a patient's anatomy to a manikin by touched landmarks."));
    parser.addOption(
        {kSite, words("File of the site, saved after every step; a stored site is continued."),
         QStringLiteral("FILE"), defaultSite()});
    parser.addOption({kSimulatedTracker, words("Use a simulated tracker and manikin.")});
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
    program::addTrackerOption(parser);
    program::addSizeOption(parser);
    program::addPatientOptions(parser);
}

Result<bool> hasScriptedHand(const QCommandLineParser& parser)
{
    const QString who = parser.value(kHands);
    if (who != kScripted && who != QStringLiteral("off"))
        return fail(Errc::WrongOption,
                    "--hands takes scripted or off, not '" + who.toStdString() + "'");
    return who == kScripted;
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

/// The tracker that the stylus is touched under, and with it, where it is simulated, the manikin.
struct Workplace {
    QString name; ///< of the tracker, as shown
    ReadSessionClock clock;
    std::optional<SimulatedWorkplace> simulated{};
    std::unique_ptr<Tracker> device{};

    [[nodiscard]] Tracker& tracker() const { return device ? *device : *simulated->tracker; }
};

Result<Workplace> workplaceOf(const QCommandLineParser& parser,
                              const program::ChosenPatient& patient)
{
    const auto described = program::trackerOption(parser);
    if (!described)
        return tl::unexpected(described.error());
    if (described->has_value() == parser.isSet(kSimulatedTracker))
        return fail(Errc::WrongOption, "name one tracker: --tracker FILE or --simulated-tracker");
    if (*described) {
        const auto clock = [] {
            return std::optional{SessionTime{monotonicNow().time_since_epoch()}};
        };
        return NdiTracker::make(**described, clock).map([&](std::unique_ptr<NdiTracker> device) {
            return Workplace{program::trackerName(**described), clock, {}, std::move(device)};
        });
    }
    return simulatedWorkplace(patient.model->landmarks(), patient.model->tube())
        .map([](SimulatedWorkplace simulated) {
            const ReadSessionClock clock = simulated.clock;
            return Workplace{program::simulatedTrackerName(), clock, std::move(simulated), {}};
        });
}

Result<int> show(const QCommandLineParser& parser, const program::ChosenPatient& patient,
                 const QSize& size, bool scripted)
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
    auto site = RegistrationModel::siteOf(siteFile, *patient.model);
    if (!site)
        return tl::unexpected(site.error());
    if (auto writable = writeSiteFile(siteFile, *site); !writable)
        return tl::unexpected(writable.error());
    const auto workplace = workplaceOf(parser, patient);
    if (!workplace)
        return tl::unexpected(workplace.error());
    if (auto started = workplace->tracker().start(); !started)
        return tl::unexpected(started.error());

    RegistrationModel registration{{.file = siteFile,
                                    .tracker = &workplace->tracker(),
                                    .trackerName = workplace->name,
                                    .clock = workplace->clock,
                                    .landmarks = landmarkSetsOf(patient),
                                    .checks = checkPlacesOf(patient)},
                                   std::move(*site),
                                   *patient.model};
    const auto journal = journalOf(registration, parser);
    if (!journal)
        return tl::unexpected(journal.error());
    std::optional<ScriptedHand> hand;
    if (scripted && workplace->simulated)
        hand.emplace(registration, *workplace->simulated);
    RegistrationWindow window{registration};
    window.resize(size);
    window.show();
    return parser.isSet(kMeasure) ? measure(window, registration, *workplace->simulated, parser)
                                  : QApplication::exec();
}

Result<int> run(const QCommandLineParser& parser)
{
    const auto size = program::sizeOption(parser);
    if (!size)
        return tl::unexpected(size.error());
    const auto scripted = hasScriptedHand(parser);
    if (!scripted)
        return tl::unexpected(scripted.error());
    if (parser.isSet(kMeasure))
        if (const auto opened = openFolder(parser.value(kMeasure).toStdString()); !opened)
            return tl::unexpected(opened.error());
    if (parser.isSet(kMeasure) && !parser.isSet(kSimulatedTracker))
        return fail(Errc::WrongOption, "--measure needs --simulated-tracker");
    if (const auto drawn = program::checkGraphics(); !drawn)
        return tl::unexpected(drawn.error());
    const auto patient = program::choosePatient(parser);
    if (!patient)
        return tl::unexpected(patient.error());
    return show(parser, *patient, *size, *scripted);
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
