#include "apps/instructor/console.h"
#include "apps/instructor/scripted_console.h"
#include "apps/program/measurement.h"
#include "apps/program/options/site_option.h"
#include "apps/program/options/tracker_option.h"
#include "apps/program/tracker_question.h"
#include "engine/io/site/site_file.h"

#include <QDir>
#include <QTimer>

#include <utility>

namespace carina
{
namespace
{

/// Measures the window while a script works its controls, then leaves.
int measure(ConsoleSession& session, const program::MeasureOptions& options)
{
    InstructorWindow& window = session.window();
    program::Measurement measurement{window, window.stationScene()};
    ScriptedConsole script{window, session.node(), session.breathing()};
    QTimer::singleShot(options.seconds * 1000, [&] {
        const auto wrote = measurement.write(QDir{options.folder}, QStringLiteral("instructor"),
                                             {{QStringLiteral("console"), script.report()}});
        QApplication::exit(wrote ? 0 : program::refuse(wrote.error()));
    });
    return QApplication::exec();
}

/// The tracker that `--tracker` names; without it none, whatever the site names, by which readiness
/// is then judged alone.
Result<ConsoleTracker> trackerFrom(const QCommandLineParser& parser)
{
    program::TrackerChange::Beginning beginning{.site = program::siteOption(parser),
                                                .isOfSite = program::namesSiteDevices(parser),
                                                .conversation =
                                                    program::recordDeviceOption(parser)};
    if (program::namesTracker(parser)) {
        auto chosen = program::readSessionTracker(parser);
        if (!chosen)
            return tl::unexpected(chosen.error());
        beginning.tracker = *std::move(chosen);
        if (!beginning.site.isEmpty())
            if (const auto site = readSiteFile(beginning.site.toStdString()); !site)
                return tl::unexpected(site.error());
    }
    return ConsoleTracker{program::TrackerChange{beginning}, beginning.tracker,
                          program::recordOption(parser)};
}

Result<int> run(const QCommandLineParser& parser)
{
    const auto options = consoleOptions(parser);
    if (!options)
        return tl::unexpected(options.error());
    if (const auto drawn = program::checkGraphics(); !drawn)
        return tl::unexpected(drawn.error());
    auto tracker = trackerFrom(parser);
    if (!tracker)
        return tl::unexpected(tracker.error());
    Console console{parser, *options, *std::move(tracker)};
    if (const auto begun = console.begin(); !begun)
        return tl::unexpected(begun.error());
    const int status = options->measure.folder.isEmpty()
                           ? QApplication::exec()
                           : measure(*console.session(), options->measure);
    if (console.session() != nullptr)
        console.session()->finish();
    return status;
}

} // namespace
} // namespace carina

int main(int argc, char** argv)
{
    return carina::program::runProgram({.name = QStringLiteral("carina-instructor"),
                                        .addOptions = carina::addConsoleOptions,
                                        .run = carina::run},
                                       argc, argv);
}
