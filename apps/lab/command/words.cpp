#include "apps/lab/command/words.h"

namespace carina::lab
{
namespace
{

QString nameOf(const Option& option) { return QString::fromLatin1(option.name); }

/// A letter has one dash, a word two.
QString asTyped(const QString& option)
{
    return (option.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + option;
}

bool mayRepeat(const Command& command, const QString& name)
{
    for (const Use& use : command.uses)
        for (const Option& option : use.options)
            if (nameOf(option) == name)
                return option.repeats;
    return false;
}

} // namespace

Words::Words(const Command& command)
    : m_command{QString::fromLatin1(command.name)}, m_parser{std::make_unique<QCommandLineParser>()}
{
    QStringList declared;
    for (const Use& use : command.uses)
        for (const Option& option : use.options) {
            if (declared.contains(nameOf(option)))
                continue; // several uses share it
            declared += nameOf(option);
            m_parser->addOption(
                QCommandLineOption{nameOf(option), {}, QString::fromLatin1(option.value)});
        }
}

Result<Words> Words::read(const Command& command, const QStringList& arguments)
{
    Words words{command};
    const bool parsed = words.m_parser->parse(QStringList{words.m_command} + arguments);
    if (const QStringList unknown = words.m_parser->unknownOptionNames(); !unknown.isEmpty())
        return words.refuse(QStringLiteral("has no option %1.").arg(asTyped(unknown.front())));
    if (!parsed) // a value that is missing, or one that is too many
        return fail(
            Errc::WrongOption,
            (words.m_command + QStringLiteral(": ") + words.m_parser->errorText()).toStdString());
    const QStringList given = words.m_parser->optionNames();
    for (const QString& option : given) {
        if (given.count(option) > 1 && !mayRepeat(command, option))
            return words.refuse(QStringLiteral("has %1 twice.").arg(asTyped(option)));
        // The parser takes whatever comes next; a value may begin with one dash, as -5 does.
        const QStringList values = words.m_parser->values(option);
        for (const QString& value : values)
            if (value.startsWith(QStringLiteral("--")))
                return words.refuse(
                    QStringLiteral("needs a value for %1, not %2.").arg(asTyped(option), value));
    }
    if (words.files().size() > command.mostFiles)
        return words.refuse(
            QStringLiteral("does not take '%1'.").arg(words.files()[command.mostFiles]));
    return words;
}

bool Words::has(const Option& option) const { return m_parser->isSet(nameOf(option)); }

QString Words::text(const Option& option) const { return m_parser->value(nameOf(option)); }

QStringList Words::texts(const Option& option) const { return m_parser->values(nameOf(option)); }

QStringList Words::files() const { return m_parser->positionalArguments(); }

Result<double> Words::number(const Option& option, double least, double greatest) const
{
    bool isNumber = false;
    const double number = text(option).toDouble(&isNumber);
    if (isNumber && number >= least && number <= greatest)
        return number;
    return refuse(QStringLiteral("needs --%1 with a number from %2 to %3.")
                      .arg(nameOf(option))
                      .arg(least)
                      .arg(greatest));
}

Result<double> Words::number(const Option& option, double least, double greatest,
                             double otherwise) const
{
    return has(option) ? number(option, least, greatest) : Result<double>{otherwise};
}

Result<std::int64_t> Words::whole(const Option& option, std::int64_t least, std::int64_t greatest,
                                  std::int64_t otherwise) const
{
    if (!has(option))
        return otherwise;
    bool isNumber = false;
    const qlonglong number = text(option).toLongLong(&isNumber);
    if (isNumber && number >= least && number <= greatest)
        return number;
    return refuse(QStringLiteral("needs --%1 with a whole number from %2 to %3.")
                      .arg(nameOf(option))
                      .arg(least)
                      .arg(greatest));
}

tl::unexpected<Error> Words::unknownWord(const Option& option, const QStringList& known) const
{
    return refuse(QStringLiteral("has no --%1 %2; choose one of %3.")
                      .arg(nameOf(option), text(option), known.join(QStringLiteral(", "))));
}

tl::unexpected<Error> Words::refuse(const QString& sentence) const
{
    return fail(Errc::WrongOption, (m_command + QLatin1Char(' ') + sentence).toStdString());
}

} // namespace carina::lab
