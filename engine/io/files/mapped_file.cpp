#include "engine/io/files/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace carina
{
namespace
{

/// Closes the file on destruction; a mapping outlives it.
class OpenFile
{
public:
    explicit OpenFile(const std::filesystem::path& file)
        : m_file{open(file.c_str(), O_RDONLY | O_CLOEXEC)}
    {
    }
    ~OpenFile()
    {
        if (m_file >= 0)
            close(m_file);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] int number() const { return m_file; }

private:
    int m_file;
};

} // namespace

Result<MappedFile> MappedFile::of(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return fail(Errc::FileNotFound, file.string() + ": no such file");
    const OpenFile opened{file};
    struct stat found {
    };
    if (opened.number() < 0 || fstat(opened.number(), &found) != 0 || !S_ISREG(found.st_mode))
        return fail(Errc::FileUnreadable, file.string() + ": cannot be read");
    const auto size = static_cast<std::size_t>(found.st_size);
    if (size == 0)
        return fail(Errc::FileEmpty, file.string() + ": it is empty");
    void* const memory =
        mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, opened.number(), 0);
    if (memory == MAP_FAILED)
        return fail(Errc::FileUnreadable, file.string() + ": cannot be mapped");
    return MappedFile{{static_cast<const std::byte*>(memory), size}};
}

MappedFile::MappedFile(MappedFile&& other) noexcept : m_bytes{std::exchange(other.m_bytes, {})} {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept
{
    std::swap(m_bytes, other.m_bytes);
    return *this;
}

MappedFile::~MappedFile()
{
    if (!m_bytes.empty())
        munmap(const_cast<std::byte*>(m_bytes.data()), m_bytes.size());
}

} // namespace carina
