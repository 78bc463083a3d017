#include "apps/lab/command.h"

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

void printHelp()
{
    print(stdout, "carina-lab COMMAND ARGS... : measures, and prints one JSON object.\n\n");
    for (const Command& command : commands())
        if (!command.help.empty())
            print(stdout, QByteArray{command.help.data(), qsizetype(command.help.size())} + '\n');
}

} // namespace

int runCommandLine(const QStringList& arguments)
{
    const QString name = arguments.value(1);
    if (name == QStringLiteral("help") || name == QStringLiteral("--help")) {
        printHelp();
        return 0;
    }
    for (const Command& command : commands()) {
        if (name.toStdString() != command.name)
            continue;
        const Result<QJsonObject> object = command.run(arguments.mid(2));
        if (!object) {
            print(stderr, QByteArray::fromStdString(object.error().detail) + '\n');
            return 1;
        }
        print(stdout, QJsonDocument{*object}.toJson());
        return 0;
    }
    print(stderr, name.isEmpty() ? QByteArray{"carina-lab needs a command"}
                                 : "carina-lab knows no command '" + name.toUtf8() + '\'');
    print(stderr, "; 'carina-lab help' lists them.\n");
    return 2;
}

} // namespace carina::lab
