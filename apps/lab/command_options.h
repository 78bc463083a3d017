#pragma once

#include "engine/core/result.h"

#include <QCommandLineParser>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

namespace carina::lab
{

/// Options that take a value, by their names.
void addValueOptions(QCommandLineParser& parser, std::initializer_list<const char*> names);

/// Reads the words after a command's name: options, their values, and files.
/// @param command that the sentence names which says what is wrong
/// @param mostFiles words that are neither options nor their values
/// @returns OutOfRange for an option that is not known, a value that is missing or too many, or
///          more files; the sentence names it.
[[nodiscard]] Result<void> parseOptions(QCommandLineParser& parser, const char* command,
                                        const QStringList& arguments, qsizetype mostFiles = 0);

/// The number given for an option, between two bounds.
/// @returns OutOfRange for anything else, NaN included.
[[nodiscard]] Result<double> numberOption(const QCommandLineParser& parser, const char* command,
                                          const char* name, double least, double greatest);

/// That an option knows no such word, and which it knows.
[[nodiscard]] tl::unexpected<Error> unknownWord(const QCommandLineParser& parser,
                                                const char* command, const char* name,
                                                const QStringList& known);

/// What the word given for an option stands for: `value` of the one of `known` that has it for a
/// name; what a value begins as where the option is not given.
/// @returns OutOfRange for any other word.
template <class Named, std::size_t Count, class Value>
[[nodiscard]] Result<Value> wordOption(const QCommandLineParser& parser, const char* command,
                                       const char* name, const std::array<Named, Count>& known,
                                       Value Named::*value)
{
    if (!parser.isSet(QString::fromLatin1(name)))
        return Value{};
    const std::string word = parser.value(QString::fromLatin1(name)).toStdString();
    const auto* named = std::ranges::find(known, word, &Named::name);
    if (named != known.end())
        return named->*value;
    QStringList words;
    for (const Named& each : known)
        words += QString::fromLatin1(each.name.data(), qsizetype(each.name.size()));
    return unknownWord(parser, command, name, words);
}

} // namespace carina::lab
