#include "apps/program/options/entry_option.h"

#include "apps/program/program.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/entry/join_link.h"
#include "engine/net/entry/psk_identity.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QStringList>
#include <QTextStream>
#include <QThread>

#include <cstdio>
#include <optional>
#include <unistd.h>

namespace carina::program
{
namespace
{

constexpr int kCodeFilePatience_ms = 30'000;
constexpr int kLookAgain_ms = 50;

const QString kCode = QStringLiteral("code");
const QString kCodeFile = QStringLiteral("code-file");
const QString kHost = QStringLiteral("host");
const QString kData = QStringLiteral("data");
const QString kHostName = QStringLiteral("host-name");
const QString kAuthority = QStringLiteral("authority");

const QString kStandardInput = QStringLiteral("-");

void say(const QString& sentence) { std::fprintf(stderr, "%s\n", qPrintable(sentence)); }

Result<std::string> textOf(const QString& file)
{
    const QDeadlineTimer deadline{kCodeFilePatience_ms};
    if (!QFile::exists(file))
        say(QApplication::translate("Entry", "Waiting up to %1 s for the file of codes, %2 …")
                .arg(kCodeFilePatience_ms / 1000)
                .arg(file));
    while (!QFile::exists(file) && !deadline.hasExpired())
        QThread::msleep(kLookAgain_ms);
    return readWholeFile(file.toStdString(), kCredentialLimit);
}

/// The code of the role in a line: "role code", or a code alone; nothing in the line of another.
std::optional<Result<JoinCode>> codeInLine(const QString& line, Role role)
{
    const QStringList words = line.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (words.isEmpty())
        return std::nullopt;
    if (words.size() == 1)
        return JoinCode::parse(words[0].toStdString());
    return words[0].toStdString() == roleWord(role)
               ? std::optional{JoinCode::parse(words[1].toStdString())}
               : std::nullopt;
}

Result<JoinCode> noCode(const QString& source, Role role)
{
    return fail(Errc::FileMalformed,
                source.toStdString() + ": it has no code for a " + std::string{roleWord(role)});
}

QString codeWantedText(Role role)
{
    switch (role) {
    case Role::Instructor:
        return QApplication::translate("Entry", "Type the code for instructors, then Enter:");
    case Role::Trainee:
        return QApplication::translate("Entry", "Type the code for trainees, then Enter:");
    case Role::Observer:
        return QApplication::translate("Entry", "Type the code for observers, then Enter:");
    }
    return {};
}

/// Not until the end of the input: a person types one line.
Result<JoinCode> codeInStandardInput(Role role)
{
    if (isatty(STDIN_FILENO) != 0)
        say(codeWantedText(role));
    QTextStream input{stdin};
    QString line;
    while (input.readLineInto(&line))
        if (const auto code = codeInLine(line, role))
            return *code;
    return noCode(QStringLiteral("standard input"), role);
}

Result<JoinCode> codeInFile(const QString& file, Role role)
{
    if (file == kStandardInput)
        return codeInStandardInput(role);
    const auto text = textOf(file);
    if (!text)
        return tl::unexpected(text.error());
    for (const QString& line : QString::fromStdString(*text).split(QLatin1Char('\n')))
        if (const auto code = codeInLine(line, role))
            return *code;
    return noCode(file, role);
}

/// Everybody on this computer can see the words that a program was started with.
void warnOfCodeInSight()
{
    say(QApplication::translate("Entry",
                                "Everybody on this computer can read a code on the command line: "
                                "leave it in a file, or type it, with --code-file."));
}

} // namespace

void addEntryOptions(QCommandLineParser& parser)
{
    parser.addPositionalArgument(
        QStringLiteral("link"),
        QApplication::translate("Entry", "A link to a session, which the instructor's window "
                                         "shows: it contains address, port, role and code."),
        QStringLiteral("[carina:join?...]"));
    parser.addOption({kCode,
                      QApplication::translate("Entry", "The code of your role, from the "
                                                       "instructor's window; needed the first "
                                                       "time only. Others on this computer can "
                                                       "read it here: rather use --code-file."),
                      QStringLiteral("CODE")});
    parser.addOption({kCodeFile,
                      QApplication::translate("Entry", "Read the code from this file: one of the "
                                                       "instructor's --codes, or a code alone; - "
                                                       "is standard input."),
                      QStringLiteral("FILE")});
    parser.addOption({kHost,
                      QApplication::translate("Entry", "Address of the instructor's computer."),
                      QStringLiteral("ADDRESS"), QStringLiteral("127.0.0.1")});
    parser.addOption({kHostName,
                      QApplication::translate("Entry", "Join only a host with a certificate for "
                                                       "this name, or this address."),
                      QStringLiteral("NAME")});
    parser.addOption({kAuthority,
                      QApplication::translate("Entry", "Join only a host with a certificate from "
                                                       "an authority in this file (PEM), in place "
                                                       "of those that the system trusts."),
                      QStringLiteral("FILE")});
    parser.addOption(
        {kData,
         QApplication::translate(
             "Entry", "Folder for the keys with which this program joins a session again."),
         QStringLiteral("DIR"), QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)});
}

Result<void> readEntryOptions(const QCommandLineParser& parser, JoinSettings& settings)
{
    settings.address = parser.value(kHost).toStdString();
    settings.tokens = QDir{dataFolder(parser)}.filePath(QStringLiteral("tokens")).toStdString();
    if (const auto opened = openFolder(settings.tokens); !opened)
        return opened;
    if (parser.isSet(kHostName) || parser.isSet(kAuthority))
        settings.certificate = ExpectedHost{parser.value(kHostName).toStdString(),
                                            parser.value(kAuthority).toStdString()};
    if (!parser.isSet(kCode) && !parser.isSet(kCodeFile))
        return {};
    if (parser.isSet(kCode))
        warnOfCodeInSight();
    const auto code = parser.isSet(kCode) ? JoinCode::parse(parser.value(kCode).toStdString())
                                          : codeInFile(parser.value(kCodeFile), settings.role);
    if (!code)
        return tl::unexpected(code.error());
    settings.code = *code;
    return {};
}

QString dataFolder(const QCommandLineParser& parser) { return parser.value(kData); }

Result<QString> linkArgument(const QCommandLineParser& parser)
{
    const QString link = parser.positionalArguments().value(0);
    if (link.isEmpty())
        return link;
    const QStringList given = parser.optionNames();
    for (const QString& said :
         {kHost, QStringLiteral("port"), QStringLiteral("observe"), kCode, kCodeFile})
        if (given.contains(said))
            return fail(Errc::WrongOption,
                        "the link contains address, port, role and code: leave out --"
                            + said.toStdString());
    warnOfCodeInSight();
    return link;
}

Result<void> readLink(const QString& link, JoinSettings& settings)
{
    return joinLink(link.toStdString()).map([&](const JoinLink& read) {
        settings.address = read.address;
        settings.port = read.port;
        settings.role = read.role;
        settings.code = read.code;
        if (read.certificate.empty())
            return;
        if (!settings.certificate)
            settings.certificate.emplace();
        settings.certificate->name = read.certificate;
    });
}

Result<void> writeCodes(const QString& file, const JoinCodes& codes)
{
    std::string text;
    for (const auto& [role, code] : codes)
        text += std::string{roleWord(role)} + ' ' + code.text() + '\n';
    return writePrivateFile(QFileInfo{file}.absoluteFilePath().toStdString(), text);
}

} // namespace carina::program
