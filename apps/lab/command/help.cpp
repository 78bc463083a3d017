#include "apps/lab/command/help.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr qsizetype kLineWidth = 96;
constexpr qsizetype kTextIndent = 4;
constexpr qsizetype kHelpColumn = 24; ///< where the help of options and keys begins
constexpr qsizetype kOverviewColumn = 16;

/// Appends words to lines that begin at `column` and are no longer than kLineWidth; the first goes
/// on where the text ends.
void appendBroken(QString& text, const QString& words, qsizetype column)
{
    qsizetype at = text.size() - 1 - text.lastIndexOf(QLatin1Char('\n'));
    bool begins = true;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (begins || at + 1 + word.size() > kLineWidth) {
            if (!begins || at > column) {
                text += QLatin1Char('\n');
                at = 0;
            }
            text += QString(column - at, QLatin1Char(' '));
            at = column;
        } else {
            text += QLatin1Char(' ');
            ++at;
        }
        text += word;
        at += word.size();
        begins = false;
    }
    text += QLatin1Char('\n');
}

/// A name and what it means, beside it; on the next line where the name is too long.
void appendEntry(QString& text, const QString& name, const char* help, qsizetype indent)
{
    text += QString(indent, QLatin1Char(' ')) + name;
    text += QLatin1Char(indent + name.size() < kHelpColumn ? ' ' : '\n');
    appendBroken(text, QString::fromUtf8(help), kHelpColumn);
}

QString typed(const Option& option)
{
    const QString name = QStringLiteral("--") + QLatin1StringView{option.name};
    return *option.value == '\0' ? name : name + QLatin1Char(' ') + QLatin1StringView{option.value};
}

void appendUse(QString& text, const Command& command, const Use& use)
{
    for (const char* line : use.lines) {
        text += QLatin1StringView{command.name};
        if (*line != '\0')
            text += QLatin1Char(' ') + QString::fromUtf8(line);
        text += QLatin1Char('\n');
    }
    appendBroken(text, QString::fromUtf8(use.text), kTextIndent);
    for (const Note& note : use.notes)
        appendEntry(text, QString::fromUtf8(note.name), note.help, kTextIndent);
    for (const Option& option : use.options)
        appendEntry(text, typed(option), option.help, kTextIndent);
    if (*use.schema.help == '\0')
        return;
    const QString schema =
        QLatin1Char('"') + QString::fromLatin1(use.schema.help) + QLatin1Char('"');
    text += QStringLiteral("  prints\n");
    appendEntry(text, use.schema, schema.toUtf8().constData(), kTextIndent);
    for (const Key& key : use.keys)
        appendEntry(text, key, key.help, kTextIndent + 2 * key.depth);
}

} // namespace

QString overviewOf(std::span<const Command> commands)
{
    QString text = QStringLiteral("carina-lab COMMAND ARGS... runs a measurement and prints one "
                                  "JSON object.\n'carina-lab help COMMAND' describes a command.\n");
    QStringList themes;
    for (const Command& command : commands)
        if (*command.theme != '\0' && !themes.contains(QLatin1StringView{command.theme}))
            themes += QLatin1StringView{command.theme};
    for (const QString& theme : themes) {
        text += QLatin1Char('\n') + theme + QLatin1Char('\n');
        for (const Command& command : commands)
            if (theme == QLatin1StringView{command.theme}) {
                text += QStringLiteral("  ") + QLatin1StringView{command.name};
                appendBroken(text, QString::fromUtf8(command.summary), kOverviewColumn);
            }
    }
    return text;
}

QString pageOf(const Command& command)
{
    QString text;
    for (const Use& use : command.uses) {
        if (!text.isEmpty())
            text += QLatin1Char('\n');
        appendUse(text, command, use);
    }
    return text;
}

} // namespace carina::lab
