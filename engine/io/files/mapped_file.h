#pragma once

#include "engine/core/result.h"
#include "engine/io/files/file_limit.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace carina
{

/// A file mapped into memory, read-only: pages are read on access and belong to the system's page
/// cache, not to this program.
///
/// Only for files that are replaced by renaming (writeWholeFile): access to a page beyond the end
/// of a file that was truncated meanwhile ends the program.
class MappedFile
{
public:
    /// @returns what readableSize returns, and FileUnreadable where it cannot be mapped.
    [[nodiscard]] static Result<MappedFile> of(const std::filesystem::path& file,
                                               const FileLimit& limit);

    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    ~MappedFile();

    /// Valid as long as this object.
    [[nodiscard]] std::span<const std::byte> bytes() const { return m_bytes; }

private:
    explicit MappedFile(std::span<const std::byte> bytes) : m_bytes{bytes} {}

    std::span<const std::byte> m_bytes;
};

} // namespace carina
