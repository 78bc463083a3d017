#pragma once

#include "engine/core/result.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSize>
#include <QString>

#include <memory>

namespace carina::program
{

/// The parts of a program with a window that differ between programs.
struct Program {
    QString name; ///< also names its folders, such as "carina-trainee"
    /// Adds its description and options; "--help" is added automatically.
    void (*addOptions)(QCommandLineParser& parser);
    /// The largest number of positional arguments.
    qsizetype mostWords = 0;
    /// Checks the options, makes the windows, and runs until the last of them is closed.
    /// @returns the exit status, or the error that ends the program
    Result<int> (*run)(const QCommandLineParser& parser);
};

/// The `main` of a program with a window: shows help, which needs no display; creates the
/// application with theme and translations; refuses unknown options; runs the program and writes
/// its error to stderr, and shows it in a window where nobody reads stderr (isSeenOnly).
/// @returns the exit status: 2 after a command line that cannot be used, 1 after another error
int runProgram(const Program& program, int argc, char** argv);

/// The options for measuring a program.
struct MeasureOptions {
    QString folder; ///< empty: do not measure
    int seconds = 20;
    QSize size{1280, 800};
};

/// The application, with OpenGL settings and the display platform selected. Without a display it
/// still starts, to report wrong options or, by checkGraphics, that there is no display; what Qt
/// warns of meanwhile is kept back unless QT_DEBUG_PLUGINS is set. `argc` must outlive it.
[[nodiscard]] std::unique_ptr<QApplication> makeApplication(int& argc, char** argv);

/// @returns NoGraphics if there is no display or no OpenGL.
[[nodiscard]] Result<void> checkGraphics();

/// Adds `--measure DIR`, `--seconds N` and `--size WxH`.
void addMeasureOptions(QCommandLineParser& parser);
/// @returns WrongOption for an invalid number or size; FileUnwritable for a folder that cannot be
///          created or written into, before anything is measured.
[[nodiscard]] Result<MeasureOptions> measureOptions(const QCommandLineParser& parser);

/// Adds `--size WxH`, of the window; addMeasureOptions includes it.
void addSizeOption(QCommandLineParser& parser);
/// The size given with `--size`; 1280x800 where the option is absent.
/// @returns WrongOption for an invalid size.
[[nodiscard]] Result<QSize> sizeOption(const QCommandLineParser& parser);

/// A UDP port from `--port`. @returns WrongOption for something else.
[[nodiscard]] Result<std::uint16_t> portOption(const QCommandLineParser& parser);

/// Whether a person sees the windows of this program, and not its stderr, because it was started
/// from an icon: stderr is no terminal. Scripts set CARINA_UNATTENDED so that nothing waits for a
/// person.
[[nodiscard]] bool isSeenOnly();

/// Shows an error in a window and asks whether to do something else instead.
/// @param action the words on the button for it
[[nodiscard]] bool askInstead(const Error& error, const QString& action);

/// Writes an error to stderr; the program continues.
void warn(const Error& error);

/// Writes the error that ends the program to stderr.
/// @returns the exit status: 2 for WrongOption, else 1
int refuse(const Error& error);

} // namespace carina::program
