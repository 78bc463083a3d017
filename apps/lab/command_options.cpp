#include "apps/lab/command_options.h"

namespace carina::lab
{
namespace
{

tl::unexpected<Error> refuse(const QString& sentence)
{
    return fail(Errc::OutOfRange, sentence.toStdString());
}

/// A letter has one dash, a word two.
QString asTyped(const QString& option)
{
    return (option.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + option;
}

} // namespace

void addValueOptions(QCommandLineParser& parser, std::initializer_list<const char*> names)
{
    for (const char* name : names) {
        const QString word = QString::fromLatin1(name);
        parser.addOption(QCommandLineOption{word, {}, word});
    }
}

Result<void> parseOptions(QCommandLineParser& parser, const char* command,
                          const QStringList& arguments, qsizetype mostFiles)
{
    const bool parsed = parser.parse(QStringList{QString::fromLatin1(command)} + arguments);
    const QString name = QString::fromLatin1(command);
    if (const QStringList unknown = parser.unknownOptionNames(); !unknown.isEmpty())
        return refuse(QStringLiteral("%1 knows no option %2.").arg(name, asTyped(unknown.front())));
    if (!parsed) // a value that is missing, or one that is too many
        return refuse(QStringLiteral("%1: %2").arg(name, parser.errorText()));
    if (const QStringList words = parser.positionalArguments(); words.size() > mostFiles)
        return refuse(QStringLiteral("%1 has no use for '%2'.").arg(name, words[mostFiles]));
    return {};
}

Result<double> numberOption(const QCommandLineParser& parser, const char* command, const char* name,
                            double least, double greatest)
{
    bool isNumber = false;
    const double number = parser.value(QString::fromLatin1(name)).toDouble(&isNumber);
    if (isNumber && number >= least && number <= greatest)
        return number;
    return fail(Errc::OutOfRange, QStringLiteral("%1 needs --%2 with a number from %3 to %4.")
                                      .arg(QString::fromLatin1(command), QString::fromLatin1(name))
                                      .arg(least)
                                      .arg(greatest)
                                      .toStdString());
}

tl::unexpected<Error> unknownWord(const QCommandLineParser& parser, const char* command,
                                  const char* name, const QStringList& known)
{
    return fail(Errc::OutOfRange,
                QStringLiteral("%1 knows no --%2 %3; it knows %4.")
                    .arg(QString::fromLatin1(command), QString::fromLatin1(name),
                         parser.value(QString::fromLatin1(name)), known.join(QStringLiteral(", ")))
                    .toStdString());
}

} // namespace carina::lab
