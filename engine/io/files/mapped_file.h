#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace carina
{

/// A file as memory: its pages are read when they are looked at, and belong to the system's cache
/// of files, not to this program.
///
/// For files that are only ever replaced, by renaming another into their place (writeWholeFile): of
/// a file that somebody shortens meanwhile, looking at what is gone ends the program.
class MappedFile
{
public:
    /// @returns FileNotFound, FileUnreadable (a folder too) or FileEmpty; the detail begins with
    ///          the file.
    [[nodiscard]] static Result<MappedFile> of(const std::filesystem::path& file);

    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    ~MappedFile();

    /// Valid as long as this is.
    [[nodiscard]] std::span<const std::byte> bytes() const { return m_bytes; }

private:
    explicit MappedFile(std::span<const std::byte> bytes) : m_bytes{bytes} {}

    std::span<const std::byte> m_bytes;
};

} // namespace carina
