#pragma once

#include "engine/core/result.h"

#include <QCommandLineParser>
#include <QSize>
#include <QString>

namespace carina::program
{

/// What makes one program with a window different from the others.
struct Program {
    QString name; ///< by which its folders are found, such as "carina-trainee"
    /// Adds what it is for and its options; "--help" is added to them.
    void (*addOptions)(QCommandLineParser& parser);
    /// How many words without an option it takes.
    qsizetype mostWords = 0;
    /// Checks the options, makes the windows, and runs until the last of them is closed.
    /// @returns the exit status, or why it cannot go on
    Result<int> (*run)(const QCommandLineParser& parser);
};

/// The `main` of a program with a window: help, which needs no display; the application with theme
/// and translations; options that are not known; and on stderr why it could not go on.
/// @returns the exit status: 1 where it could not go on
int runProgram(const Program& program, int argc, char** argv);

/// How a program was asked to measure itself; nothing of it when a person uses it.
struct MeasureOptions {
    QString folder; ///< empty: do not measure
    int seconds = 20;
    QSize size{1280, 800};
};

/// What pictures are drawn with, and windows shown on. Without a display a program starts all the
/// same, to say what is wrong with its options, or by checkGraphics that there is no display.
/// Before the application is made.
void prepareDisplay();

/// @returns NoGraphics where there is no display, or no OpenGL.
[[nodiscard]] Result<void> checkGraphics();

/// Adds `--measure DIR`, `--seconds N` and `--size WxH`.
void addMeasureOptions(QCommandLineParser& parser);
/// @returns WrongOption for a number or size that is none; FileUnwritable for a folder that cannot
///          be made or written into, before anything is measured.
[[nodiscard]] Result<MeasureOptions> measureOptions(const QCommandLineParser& parser);

/// Adds `--size WxH`, of the window; what addMeasureOptions adds, too.
void addSizeOption(QCommandLineParser& parser);
/// The size given; 1280x800 where none is. @returns WrongOption for a size that is none.
[[nodiscard]] Result<QSize> sizeOption(const QCommandLineParser& parser);

/// A UDP port from `--port`. @returns WrongOption for something else.
[[nodiscard]] Result<std::uint16_t> portOption(const QCommandLineParser& parser);

/// Says on stderr what does not work, though the program goes on.
void warn(const Error& error);

/// Says on stderr why the program cannot go on, and returns its exit status.
int refuse(const Error& error);

} // namespace carina::program
