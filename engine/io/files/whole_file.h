#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace carina
{

/// Every byte of a file.
/// @returns FileNotFound, FileUnreadable (a folder too) or FileEmpty; the detail begins with the
///          file.
[[nodiscard]] Result<std::string> readWholeFile(const std::filesystem::path& file);

/// Writes a file so that it is either there whole or not at all: into a temporary file beside it,
/// on disk before it takes the name. Makes the folders it lies in.
/// @returns FileUnwritable; the detail begins with the file.
[[nodiscard]] Result<void> writeWholeFile(const std::filesystem::path& file,
                                          std::string_view bytes);

/// The same for a secret: from its first moment the file is one that only its owner may read.
[[nodiscard]] Result<void> writePrivateFile(const std::filesystem::path& file,
                                            std::string_view bytes);

/// Makes a folder where there is none, and tries to write into it, so that long work need not fail
/// at its end.
/// @returns FileUnwritable with the folder.
[[nodiscard]] Result<void> openFolder(const std::filesystem::path& folder);

} // namespace carina
