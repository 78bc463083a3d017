#pragma once

#include <filesystem>

namespace carina
{

/// A name like this one that no file has: FILE itself, else FILE-2, FILE-3 and so on, before the
/// extension.
[[nodiscard]] std::filesystem::path unusedName(const std::filesystem::path& file);

} // namespace carina
