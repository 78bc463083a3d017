#pragma once

#include "engine/net/node/session_node.h"

#include <QCommandLineParser>

namespace carina::program
{

/// Adds `--code CODE`, `--code-file FILE`, `--host ADDRESS` and `--data DIR`, by which a program
/// comes into a session, `--host-name NAME` and `--authority FILE`, each of which makes it come
/// into none without a certificate, and a join link that may stand in their place.
void addEntryOptions(QCommandLineParser& parser);

/// Takes over what they say for a role. A file of codes that is not there yet is waited for, so
/// that host and guest may be started at once.
/// @returns WrongCode for a code that is none; FileNotFound after 30 seconds; FileMalformed for a
///          file without a code of the role.
[[nodiscard]] Result<void> readEntryOptions(const QCommandLineParser& parser,
                                            JoinSettings& settings);

/// The link that stands in the place of options; empty where none does.
/// @returns WrongOption beside an option that says the same, or for a second word.
[[nodiscard]] Result<QString> linkArgument(const QCommandLineParser& parser);

/// Takes over what a link says. @returns WrongLink
[[nodiscard]] Result<void> readLink(const QString& link, JoinSettings& settings);

/// Writes "role code" lines into a file that only its owner may read.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeCodes(const QString& file, const JoinCodes& codes);

} // namespace carina::program
