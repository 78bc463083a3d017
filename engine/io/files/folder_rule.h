#pragma once

#include <filesystem>

namespace carina
{

/// Lets the process and all that it starts read files of one folder and of those below it, and do
/// nothing else with files that it does not have open (Landlock).
/// @pre hasLandlock(), and the process can gain no privileges
/// @returns false where the folder cannot be opened, or the kernel refuses.
[[nodiscard]] bool keepToFolder(const std::filesystem::path& folder);

} // namespace carina
