#pragma once

#include "engine/net/node/session_node.h"

#include <QCommandLineParser>

namespace carina::program
{

/// Adds the options for joining a session: `--code CODE`, `--code-file FILE`, `--host ADDRESS`,
/// `--data DIR`; `--host-name NAME` and `--authority FILE`, each of which requires a certificate of
/// the host; and a positional join link instead of them.
void addEntryOptions(QCommandLineParser& parser);

/// Copies the options into the settings, with the code of settings.role. A code on the command line
/// is warned of, here and in linkArgument: in a file, or from standard input, nobody else sees it.
/// Waits up to 30 s for a file of codes that does not exist yet, so that host and guest can be
/// started at the same time.
/// @returns FileUnwritable for a folder of keys that cannot be written; WrongCode for an invalid
///          code; FileNotFound after 30 s; FileMalformed for a file without a code of the role.
[[nodiscard]] Result<void> readEntryOptions(const QCommandLineParser& parser,
                                            JoinSettings& settings);

/// The folder of `--data`: of keys, and of what the program remembers.
[[nodiscard]] QString dataFolder(const QCommandLineParser& parser);

/// The join link on the command line; empty if there is none.
/// @returns WrongOption if an option is given that the link contains.
[[nodiscard]] Result<QString> linkArgument(const QCommandLineParser& parser);

/// Copies the content of a link into the settings. @returns WrongLink
[[nodiscard]] Result<void> readLink(const QString& link, JoinSettings& settings);

/// Writes "role code" lines into a file that only its owner may read.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeCodes(const QString& file, const JoinCodes& codes);

} // namespace carina::program
