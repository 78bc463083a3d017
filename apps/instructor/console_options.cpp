#include "apps/instructor/console_options.h"

#include "apps/program/control_script.h"
#include "apps/program/journal.h"
#include "apps/program/options/openigtlink_option.h"
#include "apps/program/options/patient_option.h"
#include "apps/program/options/site_option.h"
#include "apps/program/options/tracker_option.h"
#include "apps/program/options/try_option.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/sync/strategies/strategy.h"

#include <QApplication>
#include <QStandardPaths>

#include <algorithm>

namespace carina
{
namespace
{

const QString kCertificate = QStringLiteral("certificate");
const QString kStrategy = QStringLiteral("strategy");
const QString kAddStation = QStringLiteral("add-station");
const QString kPrivateKey = QStringLiteral("private-key");
const QString kDataFolder = QStringLiteral("data");
const QString kNew = QStringLiteral("new");
const QString kOpen = QStringLiteral("open");
const QString kByLink = QStringLiteral("by-link");
const QString kCodes = QStringLiteral("codes");
const QString kStart = QStringLiteral("start");
const QString kPlay = QStringLiteral("play");
const QString kStartPage = QStringLiteral("start-page");

QString optionWords(const char* text) { return QApplication::translate("Instructor", text); }

QStringList strategyNames()
{
    QStringList names;
    for (const SyncStrategy& strategy : syncStrategies())
        names += QString::fromUtf8(strategy.name.data(), qsizetype(strategy.name.size()));
    return names;
}

/// Options that say nothing of a session: with these alone the start page comes as without any.
QStringList silentOptions()
{
    return {kDataFolder, QStringLiteral("size"), QStringLiteral("site"), QStringLiteral("script")};
}

void addBeginning(QCommandLineParser& parser)
{
    parser.addOption(
        {kStartPage,
         optionWords("Show the start page, filled in by the other options. Without options it "
                     "comes by itself; with any but %1 the session begins at once.")
             .arg(QStringLiteral("--") + silentOptions().join(QStringLiteral(", --")))});
    parser.addOption(
        {kNew, optionWords("Begin a new session; the stored one is kept. Without this "
                           "option the stored session is continued, unless it has ended.")});
    parser.addOption({kDataFolder, optionWords("Folder that the session is stored in."),
                      QStringLiteral("DIR"),
                      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)});
    parser.addOption({kStart, optionWords("Start a session that is ready to start.")});
    parser.addOption(
        {kPlay,
         optionWords("Assist at an intubation that a trainee's program plays (carina-trainee "
                     "--tracker simulated:intubation=SCRIPT,after=60): oxygen, drugs and bag, by "
                     "what the monitor notes. SCRIPT is one of %1.")
             .arg(program::motionNames()),
         QStringLiteral("SCRIPT[,seed=N]")});
}

void addReach(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("port"),
                      optionWords("UDP and TCP port of the session; 0 takes a free one."),
                      QStringLiteral("P"), QStringLiteral("0")});
    parser.addOption({kOpen, optionWords("Let programs on other computers join too; without this "
                                         "option only those on this computer can.")});
    parser.addOption({kByLink, optionWords("As --open, but nobody finds the session by searching: "
                                           "only who has its link, or address and port, joins.")});
    parser.addOption({kCertificate,
                      optionWords("Authenticate this host by the certificate in this file (PEM), "
                                  "followed by the intermediate certificates of its authority."),
                      QStringLiteral("FILE")});
    parser.addOption({kPrivateKey,
                      optionWords("The key of the certificate (PEM, without a password)."),
                      QStringLiteral("FILE")});
    parser.addOption({kCodes,
                      optionWords("Write the codes to join with into this file, for scripts."),
                      QStringLiteral("FILE")});
}

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

Result<void> readReach(const QCommandLineParser& parser, ConsoleOptions& options)
{
    const auto port = program::portOption(parser);
    if (!port)
        return tl::unexpected(port.error());
    options.port = *port;
    if (parser.isSet(kOpen) && parser.isSet(kByLink))
        return fail(Errc::WrongOption, "--open and --by-link exclude each other");
    if (parser.isSet(kOpen))
        options.reach = SessionReach::Network;
    if (parser.isSet(kByLink))
        options.reach = SessionReach::ByLink;
    if (parser.isSet(kCertificate) != parser.isSet(kPrivateKey))
        return fail(Errc::WrongOption, "--certificate and --private-key need each other");
    if (parser.isSet(kCertificate))
        options.certificate = CertificateFiles{parser.value(kCertificate).toStdString(),
                                               parser.value(kPrivateKey).toStdString()};
    return {};
}

Result<void> readPlayed(const QCommandLineParser& parser, ConsoleOptions& options)
{
    if (!parser.isSet(kPlay))
        return {};
    const auto said =
        program::simulatedWordsIn(QStringLiteral("intubation=") + parser.value(kPlay));
    if (!said)
        return tl::unexpected(said.error());
    if (!said->others.isEmpty() || said->played->after > Duration{})
        return fail(Errc::WrongOption, "--play takes SCRIPT or SCRIPT,seed=N");
    options.played = said->played;
    return {};
}

Result<void> readStrategy(const QCommandLineParser& parser, ConsoleOptions& options)
{
    if (!parser.isSet(kStrategy))
        return {};
    const SyncStrategy* strategy = findSyncStrategy(parser.value(kStrategy).toStdString());
    if (!strategy)
        return fail(Errc::WrongOption,
                    "--strategy takes one of "
                        + strategyNames().join(QStringLiteral(", ")).toStdString());
    options.strategy = strategy->kind;
    return {};
}

/// Whether nothing was said of a session.
bool isBare(const QCommandLineParser& parser)
{
    return std::ranges::all_of(
        parser.optionNames(),
        [silent = silentOptions()](const QString& name) { return silent.contains(name); });
}

} // namespace

void addConsoleOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        optionWords("The instructor's console, which hosts the session."));
    addBeginning(parser);
    addReach(parser);
    program::addScriptOption(parser);
    parser.addOption(
        {kStrategy,
         optionWords("Keep what is acted on alike by this strategy: %1. Without this option "
                     "as before, in a new session by %2.")
             .arg(strategyNames().join(QStringLiteral(", ")), strategyNames().first()),
         QStringLiteral("NAME")});
    parser.addOption({kAddStation,
                      optionWords("Open a station of this name, unless there is one; with a "
                                  "patient as for --patient after a colon, such as \"Room 5: "
                                  "adult\". May be given several times."),
                      QStringLiteral("NAME")});
    program::addSiteOption(
        parser, optionWords("The start page says how far this registration can be relied on, or "
                            "without the option that of the wizard's own file."));
    program::addTrackerOption(
        parser, optionWords("The instructor's own tools are tracked by it, drawn here and seen by "
                            "everybody at the station that is shown. All but the simulated one "
                            "need --site. Without it this program has no tracker, until it is "
                            "given one."));
    program::addTryOptions(parser);
    program::addOpenIgtLinkOption(parser);
    program::addPatientOptions(parser);
    program::addMeasureOptions(parser);
    program::addJournalOption(parser);
}

Result<ConsoleOptions> consoleOptions(const QCommandLineParser& parser)
{
    const auto measure = program::measureOptions(parser);
    if (!measure)
        return tl::unexpected(measure.error());
    ConsoleOptions options{.measure = *measure,
                           .folder = parser.value(kDataFolder),
                           .codes = parser.value(kCodes),
                           .site = program::siteOption(parser),
                           .isNew = parser.isSet(kNew),
                           .starts = parser.isSet(kStart),
                           .asksFirst = parser.isSet(kStartPage) || isBare(parser)};
    if (options.asksFirst && !measure->folder.isEmpty())
        return fail(Errc::WrongOption, "--start-page waits for a person, and --measure does not");
    if (const auto reach = readReach(parser, options); !reach)
        return tl::unexpected(reach.error());
    if (const auto strategy = readStrategy(parser, options); !strategy)
        return tl::unexpected(strategy.error());
    if (const auto played = readPlayed(parser, options); !played)
        return tl::unexpected(played.error());
    auto stations = wantedStations(parser);
    if (!stations)
        return tl::unexpected(stations.error());
    options.stations = *std::move(stations);
    return options;
}

} // namespace carina
