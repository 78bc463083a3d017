#pragma once

#include <QFile>

namespace carina
{

/// What a file with people's names in it is for: its owner alone.
inline constexpr QFile::Permissions kOwnerOnly = QFile::ReadOwner | QFile::WriteOwner;

/// Opens a file that only its owner shall read: one that is created has mode 0600, and one that is
/// there has it from then on. What is no regular file, such as a pipe or /dev/null, keeps its mode.
/// @returns whether it is open
[[nodiscard]] bool openPrivately(QFile& file, QIODevice::OpenMode mode);

} // namespace carina
