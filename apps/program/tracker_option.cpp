#include "apps/program/tracker_option.h"

#include <QCoreApplication>

namespace carina::program
{
namespace
{

const QString kTracker = QStringLiteral("tracker");

} // namespace

void addTrackerOption(QCommandLineParser& parser, const QString& without)
{
    const QString meaning = QCoreApplication::translate(
        "TrackerOption", "Track with the device that this file describes, a Polaris, a server of "
                         "OpenIGTLink or a camera with its tools (docs/tracking.md); with a "
                         "simulated tracker; or with a "
                         "recording (.igs.mha of Plus or 3D Slicer), played once or looped.");
    parser.addOption({kTracker, meaning + QLatin1Char{' '} + without,
                      QStringLiteral("FILE|simulated|recorded:FILE|looped:FILE")});
}

Result<std::optional<TrackerChoice>> trackerOption(const QCommandLineParser& parser)
{
    if (!parser.isSet(kTracker))
        return std::nullopt;
    return trackerNamed(parser.value(kTracker)).map([](TrackerChoice choice) {
        return std::optional{std::move(choice)};
    });
}

} // namespace carina::program
