#include "apps/program/tracker_option.h"

#include <QCoreApplication>

namespace carina::program
{
namespace
{

const QString kTracker = QStringLiteral("tracker");

QString words(const char* text) { return QCoreApplication::translate("TrackerOption", text); }

} // namespace

void addTrackerOption(QCommandLineParser& parser)
{
    parser.addOption({kTracker,
                      words("Track with the device that this file describes: a Polaris, its port "
                            "and its tools (docs/tracking.md)."),
                      QStringLiteral("FILE")});
}

Result<std::optional<TrackerDescription>> trackerOption(const QCommandLineParser& parser)
{
    if (!parser.isSet(kTracker))
        return std::nullopt;
    return readTrackerFile(parser.value(kTracker).toStdString())
        .map([](TrackerDescription described) { return std::optional{std::move(described)}; });
}

QString trackerName(const TrackerDescription& description)
{
    return words("NDI tracker at %1").arg(QString::fromStdString(description.address));
}

} // namespace carina::program
