#pragma once

#include "apps/lab/command/command.h"

#include <QCommandLineParser>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace carina::lab
{

/// The words after a command's name, read by the options that its page declares.
class Words
{
public:
    /// @returns WrongOption for an option that is not declared, or given twice where it does not
    ///          repeat, a value that is missing or one too many, or more files than the command
    ///          takes; the sentence names it.
    [[nodiscard]] static Result<Words> read(const Command& command, const QStringList& arguments);

    [[nodiscard]] bool has(const Option& option) const;
    /// What was given for an option; empty where nothing was.
    [[nodiscard]] QString text(const Option& option) const;
    /// What was given for an option that repeats, in that order.
    [[nodiscard]] QStringList texts(const Option& option) const;
    /// The words that are neither options nor their values.
    [[nodiscard]] QStringList files() const;

    /// The number given for an option, between two bounds.
    /// @returns WrongOption for anything else, NaN included, and where it is not given
    [[nodiscard]] Result<double> number(const Option& option, double least, double greatest) const;
    /// The same; `otherwise`, which need not lie between them, where it is not given.
    [[nodiscard]] Result<double> number(const Option& option, double least, double greatest,
                                        double otherwise) const;
    /// A whole number between two bounds; `otherwise` where it is not given.
    [[nodiscard]] Result<std::int64_t> whole(const Option& option, std::int64_t least,
                                             std::int64_t greatest, std::int64_t otherwise) const;

    /// What the word given for an option stands for: `value` of the one of `known` that has it for
    /// a name; what a value begins as where the option is not given.
    /// @returns WrongOption for any other word
    template <class Named, std::size_t Count, class Value>
    [[nodiscard]] Result<Value> word(const Option& option, const std::array<Named, Count>& known,
                                     Value Named::*value) const
    {
        if (!has(option))
            return Value{};
        const auto* named = std::ranges::find(known, text(option).toStdString(), &Named::name);
        if (named != known.end())
            return named->*value;
        QStringList names;
        for (const Named& each : known)
            names += QString::fromLatin1(each.name.data(), qsizetype(each.name.size()));
        return unknownWord(option, names);
    }

    /// That an option does not accept the given word, and which words it accepts.
    [[nodiscard]] tl::unexpected<Error> unknownWord(const Option& option,
                                                    const QStringList& known) const;
    /// A refusal that begins with the command's name: "tre needs ...".
    [[nodiscard]] tl::unexpected<Error> refuse(const QString& sentence) const;

    /// For readers of options that several programs share.
    [[nodiscard]] const QCommandLineParser& parser() const { return *m_parser; }

private:
    explicit Words(const Command& command);

    QString m_command;
    std::unique_ptr<QCommandLineParser> m_parser;
};

} // namespace carina::lab
