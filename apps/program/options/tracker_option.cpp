#include "apps/program/options/tracker_option.h"

#include "apps/program/played_intubation.h"

#include <QCoreApplication>

namespace carina::program
{
namespace
{

const QString kTracker = QStringLiteral("tracker");
const QString kRecord = QStringLiteral("record");
const QString kRecordDevice = QStringLiteral("record-device");
const QString kOfSite = QStringLiteral("site");
const QString kSimulated = QStringLiteral("simulated");
const QString kSimulatedWith = QStringLiteral("simulated:");

/// As trackerNamed; the simulated one may play an intubation, too.
Result<TrackerChoice> namedTracker(const QString& words, const Progress& goesOn)
{
    if (!words.startsWith(kSimulatedWith))
        return trackerNamed(words, goesOn);
    const auto said = simulatedWordsIn(words.mid(kSimulatedWith.size()));
    if (!said)
        return tl::unexpected(said.error());
    const bool isAll = said->played && said->others.isEmpty();
    return trackerNamed(isAll ? kSimulated : kSimulatedWith + said->others)
        .map([&](TrackerChoice choice) {
            if (said->played)
                std::get<SimulatedDevice>(choice.device).play = playOf(*said->played);
            return choice;
        });
}

Result<std::optional<TrackerChoice>> chosenTracker(const QCommandLineParser& parser,
                                                   const QString& site, const Progress& goesOn)
{
    if (namesSiteDevices(parser) && site.isEmpty())
        return fail(Errc::WrongOption, "--tracker site: it needs --site, which names the devices");
    if (parser.isSet(kTracker) && !namesSiteDevices(parser))
        return namedTracker(parser.value(kTracker), goesOn).map([](TrackerChoice choice) {
            return std::optional{std::move(choice)};
        });
    if (site.isEmpty())
        return std::nullopt;
    return trackerOfSite(site.toStdString());
}

} // namespace

void addTrackerOption(QCommandLineParser& parser, const QString& without)
{
    const QString meaning = QCoreApplication::translate(
        "TrackerOption",
        "What tracks: FILE, which describes a Polaris, a server of OpenIGTLink or a camera with "
        "its tools (docs/tracking.md), or is a device set of PLUS (.xml); simulated, of which "
        "rate=HZ, hidden=TOOL, partly=TOOL, dropouts=PERCENT and with=laryngoscope can be chosen "
        "(simulated:rate=30,hidden=tube), and whose hands intubate once by a script with "
        "intubation=SCRIPT, seed=N and after=SECONDS (simulated:intubation=good); recorded:FILE "
        "or looped:FILE, a recording of Carina, Plus, 3D Slicer or a device, played once or again "
        "and again; or site, the devices that the site names.");
    // A long name of the value would leave the text of all options no room beside it.
    parser.addOption({kTracker, meaning + QLatin1Char{' '} + without, QStringLiteral("TRACKER")});
    parser.addOption(
        {kRecord,
         QCoreApplication::translate("TrackerOption",
                                     "Record the poses of the tracker's tools from the start on: "
                                     ".csv, or with another file beside it .igs.mha or .tum."),
         QStringLiteral("FILE")});
    parser.addOption(
        {kRecordDevice,
         QCoreApplication::translate("TrackerOption",
                                     "Record the bytes to and from a Polaris or a server of "
                                     "OpenIGTLink, also of one that is chosen in a window; "
                                     "recorded:FILE plays them. A file that is there is kept: the "
                                     "next one is named FILE-2."),
         QStringLiteral("FILE")});
}

bool namesTracker(const QCommandLineParser& parser) { return parser.isSet(kTracker); }

bool namesSiteDevices(const QCommandLineParser& parser)
{
    return parser.value(kTracker) == kOfSite;
}

QString recordOption(const QCommandLineParser& parser) { return parser.value(kRecord); }

std::string recordDeviceOption(const QCommandLineParser& parser)
{
    return parser.value(kRecordDevice).toStdString();
}

Result<std::optional<TrackerChoice>> trackerOption(const QCommandLineParser& parser,
                                                   const QString& site, const Progress& goesOn)
{
    auto chosen = chosenTracker(parser, site, goesOn);
    if (!chosen || !*chosen)
        return chosen;
    TrackerChoice& choice = **chosen;
    choice.conversation = recordDeviceOption(parser);
    if (parser.isSet(kRecordDevice) && !hasConversation(choice))
        return fail(Errc::WrongOption, "--record-device: a Polaris or a server of OpenIGTLink has "
                                       "bytes to record, not "
                                           + trackerName(choice).toStdString());
    return chosen;
}

} // namespace carina::program
