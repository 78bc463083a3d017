#pragma once

#include "engine/core/result.h"

#include <QCommandLineParser>
#include <QSize>
#include <QString>

class QApplication;

namespace carina::viewer
{

/// Whether the command line asks for help, which is given without a display.
[[nodiscard]] bool asksForHelp(int argc, char** argv);

/// How a program was asked to measure itself; nothing of it when a person uses it.
struct MeasureOptions {
    QString folder; ///< empty: do not measure
    int seconds = 20;
    QSize size{1280, 800};
};

/// The program's name, by which its folders are found. Before everything else.
void nameProgram(const QString& name);

/// What pictures are drawn with, and windows shown on. Without a display a program starts all the
/// same, to say what is wrong with its options, or by checkGraphics that there is no display.
/// Before the application is made.
void prepareDisplay();

/// @returns NoGraphics where there is no display, or no OpenGL.
[[nodiscard]] Result<void> checkGraphics();

/// Theme and translations that all programs with a window share.
void prepareProgram(QApplication& application);

/// Adds `--measure DIR`, `--seconds N` and `--size WxH`.
void addMeasureOptions(QCommandLineParser& parser);
/// @returns WrongOption for a number or size that is none; FileUnwritable for a folder that cannot
///          be made or written into, before anything is measured.
[[nodiscard]] Result<MeasureOptions> measureOptions(const QCommandLineParser& parser);

/// Adds `--size WxH`, of the window; what addMeasureOptions adds, too.
void addSizeOption(QCommandLineParser& parser);
/// @returns WrongOption for a size that is none.
[[nodiscard]] Result<QSize> sizeOption(const QCommandLineParser& parser);

/// A UDP port from `--port`. @returns WrongOption for something else.
[[nodiscard]] Result<std::uint16_t> portOption(const QCommandLineParser& parser);

/// @returns WrongOption where there are more words than this that no option takes.
[[nodiscard]] Result<void> checkWords(const QCommandLineParser& parser, qsizetype most);

/// Says on stderr what does not work, though the program goes on.
void warn(const Error& error);

/// Says on stderr why the program cannot go on, and returns its exit status.
int refuse(const Error& error);

} // namespace carina::viewer
