#include "apps/instructor/console.h"
#include "apps/instructor/scripted_console.h"
#include "apps/program/measurement.h"

#include <QDir>
#include <QTimer>

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

Result<int> run(const QCommandLineParser& parser)
{
    const auto options = consoleOptions(parser);
    if (!options)
        return tl::unexpected(options.error());
    if (const auto drawn = program::checkGraphics(); !drawn)
        return tl::unexpected(drawn.error());
    Console console{parser, *options};
    if (const auto begun = console.begin(); !begun)
        return tl::unexpected(begun.error());
    return options->measure.folder.isEmpty() ? QApplication::exec()
                                             : measure(*console.session(), options->measure);
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
