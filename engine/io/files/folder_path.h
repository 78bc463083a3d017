#pragma once

#include "engine/core/result.h"

#include <filesystem>

namespace carina
{

/// The file of this name in a folder or below it, without links and "..": both paths are compared
/// as the system resolves them, so that neither leads out of the folder.
/// @param name as the system takes it: whatever encodes it, such as %2e, is decoded before
/// @returns FileNotFound; FileUnreadable where it lies outside the folder. The detail begins with
///          the file.
[[nodiscard]] Result<std::filesystem::path> pathWithin(const std::filesystem::path& folder,
                                                       const std::filesystem::path& name);

} // namespace carina
