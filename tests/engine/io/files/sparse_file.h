#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace carina::test
{

constexpr std::uintmax_t kTebibyte = std::uintmax_t{1} << 40U;

/// A file that begins with `head` and has so many bytes, of which the disk stores only the head.
inline void writeSparse(const std::filesystem::path& file, std::string_view head,
                        std::uintmax_t bytes = kTebibyte)
{
    std::filesystem::create_directories(file.parent_path());
    std::ofstream{file, std::ios::binary} << head;
    std::filesystem::resize_file(file, bytes);
}

} // namespace carina::test
