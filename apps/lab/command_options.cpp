#include "apps/lab/command_options.h"

namespace carina::lab
{

void addValueOptions(QCommandLineParser& parser, std::initializer_list<const char*> names)
{
    for (const char* name : names) {
        const QString word = QString::fromLatin1(name);
        parser.addOption(QCommandLineOption{word, {}, word});
    }
}

Result<void> parseOptions(QCommandLineParser& parser, const char* command,
                          const QStringList& arguments)
{
    if (parser.parse(QStringList{QString::fromLatin1(command)} + arguments)
        && parser.positionalArguments().isEmpty())
        return {};
    return fail(Errc::OutOfRange, std::string{command}
                                      + " does not know what to do with its arguments: "
                                      + arguments.join(QLatin1Char(' ')).toStdString() + ".");
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
