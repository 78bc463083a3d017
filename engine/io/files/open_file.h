#pragma once

#include "engine/core/result.h"
#include "engine/io/files/file_limit.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace carina
{

/// A file open for reading whose size was found acceptable. What is judged and what is read are the
/// same file, even if its name is given to another one meanwhile.
class OpenFile
{
public:
    /// @returns what readableSize returns.
    [[nodiscard]] static Result<OpenFile> of(const std::filesystem::path& file,
                                             const FileLimit& limit);

    OpenFile(OpenFile&& other) noexcept;
    OpenFile& operator=(OpenFile&& other) noexcept;
    ~OpenFile();

    /// The descriptor; valid as long as this object.
    [[nodiscard]] int number() const { return m_file; }
    /// Bytes when it was opened.
    [[nodiscard]] std::uint64_t size() const { return m_size; }

    /// The next bytes of the file.
    /// @returns how many were read: fewer than fit only at the end of the file; -1 for an error.
    [[nodiscard]] std::ptrdiff_t read(std::span<std::byte> bytes) const;

private:
    OpenFile(int file, std::uint64_t size) : m_file{file}, m_size{size} {}

    int m_file;
    std::uint64_t m_size;
};

} // namespace carina
