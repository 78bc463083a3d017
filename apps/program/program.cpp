#include "apps/program/program.h"

#include "engine/core/prompt_thread.h"
#include "engine/io/files/whole_file.h"
#include "models/errors/error_text.h"
#include "models/text/shown_as_is.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/spoken_label.h"
#include "widgets/theme/dark_theme.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTranslator>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <unistd.h>

namespace carina::program
{
namespace
{

const QString kMeasure = QStringLiteral("measure");
const QString kSeconds = QStringLiteral("seconds");
const QString kSize = QStringLiteral("size");
constexpr int kWidest = 8192; ///< pixels: what every graphics driver can draw into

/// Whether the command line asks for help, which is given without a display.
bool asksForHelp(int argc, char** argv)
{
    return std::any_of(argv + 1, argv + argc, [](std::string_view word) {
        return word == "-h" || word == "--help" || word == "--help-all";
    });
}

/// What Qt warns of while it looks for a platform, such as one that it cannot use, is kept back:
/// the next one is tried, and checkGraphics says so in a sentence where there is no display.
void tellUnlessAWarning(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    if (type == QtCriticalMsg || type == QtFatalMsg)
        std::fprintf(stderr, "%s\n", qPrintable(qFormatLogMessage(type, context, text)));
}

/// Theme, translations and what is read aloud.
void prepareProgram(QApplication& application)
{
    applyDarkTheme(application);
    installSpokenLabels();
    auto* translator = new QTranslator{&application};
    const QString catalogues = QStringLiteral(":/carina/translations");
    if (translator->load(QLocale{}, QStringLiteral("carina"), QStringLiteral("_"), catalogues)
        || translator->load(QStringLiteral("carina_en"), catalogues))
        QApplication::installTranslator(translator);
}

/// A letter has one dash, a word two.
std::string asTyped(const QString& option)
{
    return (option.size() == 1 ? "-" : "--") + option.toStdString();
}

/// @returns WrongOption for an option that there is not, that lacks its value or is given twice,
///          and where there are more words than this that no option takes.
Result<void> readWords(QCommandLineParser& parser, qsizetype most)
{
    if (!parser.parse(QCoreApplication::arguments())) {
        const QStringList unknown = parser.unknownOptionNames();
        if (!unknown.isEmpty())
            return fail(Errc::WrongOption, "there is no option " + asTyped(unknown.front()));
        QString fault = parser.errorText(); // a sentence that names the option as typed
        fault.chop(fault.endsWith(QLatin1Char('.')) ? 1 : 0);
        return fail(Errc::WrongOption, fault.toStdString());
    }
    const QStringList given = parser.optionNames();
    for (const QString& option : given)
        if (given.count(option) > 1)
            return fail(Errc::WrongOption, asTyped(option) + " is given twice");
    const QStringList words = parser.positionalArguments();
    if (words.size() > most)
        return fail(Errc::WrongOption, "unexpected argument '" + words[most].toStdString() + "'");
    return {};
}

/// A window with an error, and a button to leave.
void fillBox(QMessageBox& box, const Error& error)
{
    box.setIcon(QMessageBox::Critical);
    box.setWindowTitle(QCoreApplication::applicationName());
    box.setText(shownAsIs(errorText(error)));
    box.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box.addButton(QMessageBox::Close);
}

Result<int> checkedRun(const Program& program, QCommandLineParser& parser)
{
    if (const auto right = readWords(parser, program.mostWords); !right)
        return tl::unexpected(right.error());
    return program.run(parser);
}

} // namespace

int runProgram(const Program& program, int argc, char** argv)
{
    QCoreApplication::setApplicationName(program.name);
    QCoreApplication::setOrganizationName(QStringLiteral("carina"));
    QCommandLineParser parser;
    parser.addHelpOption();
    program.addOptions(parser);
    if (asksForHelp(argc, argv)) {
        const QCoreApplication application{argc, argv};
        parser.process(application); // which ends here
    }
    makeWayForPromptThreads();
    const auto application = makeApplication(argc, argv);
    prepareProgram(*application);
    const Result<int> status = checkedRun(program, parser);
    if (status)
        return *status;
    const int failed = refuse(status.error());
    if (isSeenOnly() && !parser.isSet(kMeasure) && status.error().code != Errc::Cancelled) {
        QMessageBox box;
        fillBox(box, status.error());
        box.exec();
    }
    return failed;
}

bool isSeenOnly()
{
    return isatty(STDERR_FILENO) == 0 && qEnvironmentVariableIsEmpty("CARINA_UNATTENDED")
           && QGuiApplication::platformName() != QStringLiteral("offscreen");
}

bool askInstead(const Error& error, const QString& action)
{
    warn(error);
    QMessageBox box;
    fillBox(box, error);
    const QPushButton* instead = box.addButton(action, QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == instead;
}

std::unique_ptr<QApplication> makeApplication(int& argc, char** argv)
{
    // Qt tries them in turn, and ends a program that none of them suits.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")
        && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "xcb;offscreen");
    prepareGraphics();
    if (!qEnvironmentVariableIsEmpty("QT_DEBUG_PLUGINS"))
        return std::make_unique<QApplication>(argc, argv);
    const QtMessageHandler before = qInstallMessageHandler(tellUnlessAWarning);
    auto application = std::make_unique<QApplication>(argc, argv);
    qInstallMessageHandler(before);
    return application;
}

Result<void> checkGraphics()
{
    const auto driver = graphicsDriver();
    if (!driver && QGuiApplication::platformName() == QStringLiteral("offscreen"))
        return fail(Errc::NoGraphics, "there is no display");
    return driver.map([](const QString&) {});
}

void addMeasureOptions(QCommandLineParser& parser)
{
    parser.addOption(
        {kMeasure,
         QApplication::translate("Program", "Measure what is drawn, write the results into this "
                                            "folder, which is created if missing, and exit."),
         QStringLiteral("DIR")});
    parser.addOption({kSeconds, QApplication::translate("Program", "How long to measure."),
                      QStringLiteral("N"), QStringLiteral("20")});
    addSizeOption(parser);
}

void addSizeOption(QCommandLineParser& parser)
{
    parser.addOption(
        {kSize, QApplication::translate("Program", "Size of the window."), QStringLiteral("WxH")});
}

Result<QSize> sizeOption(const QCommandLineParser& parser)
{
    if (!parser.isSet(kSize))
        return MeasureOptions{}.size;
    const QStringList sides = parser.value(kSize).split(QLatin1Char('x'));
    const QSize size{sides.value(0).toInt(), sides.value(1).toInt()};
    if (sides.size() != 2 || size.isEmpty() || size.width() > kWidest || size.height() > kWidest)
        return fail(Errc::WrongOption, "--size needs WxH, such as 1280x800, at most 8192, not '"
                                           + parser.value(kSize).toStdString() + "'");
    return size;
}

Result<MeasureOptions> measureOptions(const QCommandLineParser& parser)
{
    MeasureOptions options{.folder = parser.value(kMeasure)};
    options.seconds = parser.value(kSeconds).toInt();
    if (options.seconds <= 0)
        return fail(Errc::WrongOption, "--seconds needs a whole number from 1, not '"
                                           + parser.value(kSeconds).toStdString() + "'");
    const auto size = sizeOption(parser);
    if (!size)
        return tl::unexpected(size.error());
    options.size = *size;
    if (!options.folder.isEmpty())
        if (const auto opened = openFolder(options.folder.toStdString()); !opened)
            return tl::unexpected(opened.error());
    return options;
}

Result<std::uint16_t> portOption(const QCommandLineParser& parser)
{
    if (parser.value(QStringLiteral("port")).isEmpty())
        return fail(Errc::WrongOption, "--port is missing; the instructor's window shows it");
    bool right = false;
    const std::uint16_t port = parser.value(QStringLiteral("port")).toUShort(&right);
    if (!right)
        return fail(Errc::WrongOption, "--port needs a number from 0 to 65535, not '"
                                           + parser.value(QStringLiteral("port")).toStdString()
                                           + "'");
    return port;
}

void warn(const Error& error) { std::fprintf(stderr, "%s\n", qPrintable(errorText(error))); }

int refuse(const Error& error)
{
    warn(error);
    return error.code == Errc::WrongOption ? 2 : 1;
}

} // namespace carina::program
