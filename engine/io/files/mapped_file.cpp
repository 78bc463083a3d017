#include "engine/io/files/mapped_file.h"

#include "engine/io/files/open_file.h"

#include <sys/mman.h>
#include <utility>

namespace carina
{

Result<MappedFile> MappedFile::of(const std::filesystem::path& file, const FileLimit& limit)
{
    const auto opened = OpenFile::of(file, limit);
    if (!opened)
        return tl::unexpected(opened.error());
    const auto size = static_cast<std::size_t>(opened->size());
    void* const memory =
        mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, opened->number(), 0);
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
