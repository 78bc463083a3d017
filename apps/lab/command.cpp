#include "apps/lab/command.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <cstdio>

namespace carina::lab
{
namespace
{

void print(std::FILE* stream, const QByteArray& text)
{
    std::fwrite(text.constData(), 1, static_cast<std::size_t>(text.size()), stream);
}

void printHelp(const Command& command)
{
    print(stdout, QByteArray{command.help.data(), qsizetype(command.help.size())});
}

void printHelp()
{
    print(stdout, "carina-lab COMMAND ARGS... : measures, and prints one JSON object.\n");
    for (const Command& command : commands()) {
        if (command.help.empty())
            continue;
        print(stdout, "\n");
        printHelp(command);
    }
}

/// What a command printed, and on stderr what it warns of.
void printObject(const QJsonObject& object)
{
    print(stdout, QJsonDocument{object}.toJson());
    for (const QJsonValue warning : object.value(kWarnings).toArray())
        print(stderr, "warning: " + warning.toString().toUtf8() + '\n');
}

bool asksForHelp(const QString& word)
{
    return word == QStringLiteral("--help") || word == QStringLiteral("-h");
}

} // namespace

int runCommandLine(const QStringList& arguments)
{
    const QString name = arguments.value(1);
    if (name == QStringLiteral("help") || asksForHelp(name)) {
        printHelp();
        return 0;
    }
    for (const Command& command : commands()) {
        if (name.toStdString() != command.name)
            continue;
        if (asksForHelp(arguments.value(2))) {
            printHelp(command);
            return 0;
        }
        const Result<QJsonObject> object = command.run(arguments.mid(2));
        if (!object) {
            print(stderr, QByteArray::fromStdString(object.error().detail) + '\n');
            return 1;
        }
        printObject(*object);
        return 0;
    }
    print(stderr, name.isEmpty() ? QByteArray{"carina-lab needs a command"}
                                 : "carina-lab knows no command '" + name.toUtf8() + '\'');
    print(stderr, "; 'carina-lab help' lists them, 'carina-lab COMMAND --help' tells of one.\n");
    return 2;
}

} // namespace carina::lab
