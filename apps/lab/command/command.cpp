#include "apps/lab/command/command.h"

#include "apps/lab/command/help.h"
#include "apps/lab/command/words.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonValue>
#include <QVariant>

#include <cmath>
#include <cstdio>

namespace carina::lab
{
namespace
{

constexpr int kWrongUse = 2; ///< exit status

void print(std::FILE* stream, const QByteArray& text)
{
    std::fwrite(text.constData(), 1, static_cast<std::size_t>(text.size()), stream);
}

QJsonValue rounded(const QJsonValue& value)
{
    constexpr int kDigits = 12;
    constexpr int kDecimals = 6;
    constexpr double kLarge = 1e6;
    if (value.isObject()) {
        QJsonObject object = value.toObject();
        for (auto field = object.begin(); field != object.end(); ++field)
            *field = rounded(*field);
        return object;
    }
    if (value.isArray()) {
        QJsonArray array;
        for (const QJsonValue each : value.toArray())
            array.append(rounded(each));
        return array;
    }
    if (value.toVariant().typeId() != QMetaType::Double)
        return value;
    const double number = value.toDouble();
    return (std::abs(number) < kLarge ? QByteArray::number(number, 'g', kDigits)
                                      : QByteArray::number(number, 'f', kDecimals))
        .toDouble();
}

/// What a command printed, and on stderr what it warns of.
void printObject(const QJsonObject& object)
{
    print(stdout, printed(object));
    for (const QJsonValue warning : object.value(kWarnings).toArray())
        print(stderr, "warning: " + warning.toString().toUtf8() + '\n');
}

bool asksForHelp(const QString& word)
{
    return word == QStringLiteral("--help") || word == QStringLiteral("-h");
}

const Command* commandNamed(std::span<const Command> commands, const QString& name)
{
    const auto found = std::ranges::find_if(commands, [&name](const Command& command) {
        return name == QLatin1StringView{command.name};
    });
    return found == commands.end() ? nullptr : &*found;
}

int refuseName(const QString& name)
{
    print(stderr, name.isEmpty() ? QByteArray{"carina-lab needs a command"}
                                 : "carina-lab has no command '" + name.toUtf8() + '\'');
    print(stderr, "; 'carina-lab help' lists them, 'carina-lab help COMMAND' describes one.\n");
    return kWrongUse;
}

int pointToHelp(const QString& name)
{
    print(stderr, "'carina-lab help " + name.toUtf8() + "' describes its options.\n");
    return kWrongUse;
}

int printHelp(std::span<const Command> commands, const QString& name)
{
    const Command* command = commandNamed(commands, name);
    if (command == nullptr && !name.isEmpty())
        return refuseName(name);
    print(stdout, (command == nullptr ? overviewOf(commands) : pageOf(*command)).toUtf8());
    return 0;
}

} // namespace

Result<QJsonObject> Command::run(const QStringList& arguments) const
{
    const Result<Words> words = Words::read(*this, arguments);
    if (words)
        return experiment(*words);
    return fail(words.error().code,
                *reminder == '\0' ? words.error().detail : words.error().detail + ' ' + reminder);
}

QByteArray printed(const QJsonObject& object)
{
    return QJsonDocument{rounded(object).toObject()}.toJson();
}

int runCommandLine(std::span<const Command> commands, const QStringList& arguments)
{
    const QString name = arguments.value(1);
    if (name == QStringLiteral("help") || asksForHelp(name))
        return printHelp(commands, arguments.value(2));
    const Command* command = commandNamed(commands, name);
    if (command == nullptr)
        return refuseName(name);
    if (std::ranges::any_of(arguments.mid(2), asksForHelp))
        return printHelp(commands, name);
    const Result<QJsonObject> object = command->run(arguments.mid(2));
    if (!object) {
        print(stderr, QByteArray::fromStdString(object.error().detail) + '\n');
        return object.error().code == Errc::WrongOption ? pointToHelp(name) : 1;
    }
    printObject(*object);
    return object->value(kAcceptable).toBool(true) ? 0 : 1;
}

} // namespace carina::lab
