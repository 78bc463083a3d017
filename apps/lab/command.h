#pragma once

#include "engine/core/result.h"

#include <QJsonObject>
#include <QStringList>

#include <span>
#include <string_view>

namespace carina::lab
{

/// One subcommand of carina-lab: an experiment that prints one JSON object.
struct Command {
    std::string_view name; ///< first word of the command line
    std::string_view help; ///< usage and the meaning of every flag and key, many lines; empty for
                           ///< one that is not for people
    /// Runs on the words after the name. The object gets the key "schema" from the command itself,
    /// such as "carina.breathe/1".
    Result<QJsonObject> (*run)(const QStringList& arguments);
};

/// The key of what a command warns of, an array of sentences: they go to stderr, too.
inline constexpr QLatin1StringView kWarnings{"warnings"};

/// All subcommands this build has.
[[nodiscard]] std::span<const Command> commands();

/// Runs carina-lab on a whole command line: prints the object on stdout and returns 0, or one
/// sentence on stderr and returns 1 (2 for a wrong command line). With --help after the name prints
/// that command's help.
int runCommandLine(const QStringList& arguments);

} // namespace carina::lab
