#pragma once

#include "engine/core/result.h"
#include "engine/io/files/file_limit.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace carina
{

/// All bytes of a file, whose size is looked at before anything is read.
/// @returns what readableSize returns, and FileUnreadable where it became shorter meanwhile.
[[nodiscard]] Result<std::string> readWholeFile(const std::filesystem::path& file,
                                                const FileLimit& limit);

/// Writes a file atomically: into a temporary file beside it, synced to disk and renamed. Creates
/// its folders.
/// @returns FileUnwritable; the detail begins with the file.
[[nodiscard]] Result<void> writeWholeFile(const std::filesystem::path& file,
                                          std::string_view bytes);

/// As writeWholeFile, for a secret: the file is created with access for its owner only.
[[nodiscard]] Result<void> writePrivateFile(const std::filesystem::path& file,
                                            std::string_view bytes);

/// Moves a finished file to its name, in the same folder, for good: the folder is synced to disk.
/// @returns FileUnwritable
[[nodiscard]] Result<void> placeFile(const std::filesystem::path& finished,
                                     const std::filesystem::path& file);

/// Creates a folder where it does not exist and checks that it can be written to, so that long work
/// does not fail at its end.
/// @returns FileUnwritable with the folder.
[[nodiscard]] Result<void> openFolder(const std::filesystem::path& folder);

} // namespace carina
