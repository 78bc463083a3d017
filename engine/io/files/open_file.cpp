#include "engine/io/files/open_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace carina
{
namespace
{

constexpr int kNone = -1;

} // namespace

Result<OpenFile> OpenFile::of(const std::filesystem::path& file, const FileLimit& limit)
{
    // Without O_NONBLOCK the opening of a pipe would wait for its other end.
    const int number = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (number < 0 && (errno == ENOENT || errno == ENOTDIR))
        return fail(Errc::FileNotFound, file.string() + ": no such file");
    OpenFile opened{number, 0};
    struct stat found {
    };
    if (number < 0 || fstat(number, &found) != 0)
        return fail(Errc::FileUnreadable, file.string() + ": cannot be read");
    if (!S_ISREG(found.st_mode))
        return fail(Errc::FileUnreadable,
                    file.string()
                        + (S_ISDIR(found.st_mode) ? ": it is a folder" : ": it is a device"));
    opened.m_size = static_cast<std::uint64_t>(found.st_size);
    if (opened.m_size == 0)
        return fail(Errc::FileEmpty, file.string() + ": it is empty");
    if (const auto good = checkSize(file, opened.m_size, limit); !good)
        return tl::unexpected(good.error());
    return opened;
}

OpenFile::OpenFile(OpenFile&& other) noexcept
    : m_file{std::exchange(other.m_file, kNone)}, m_size{other.m_size}
{
}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept
{
    std::swap(m_file, other.m_file);
    std::swap(m_size, other.m_size);
    return *this;
}

OpenFile::~OpenFile()
{
    if (m_file >= 0)
        close(m_file);
}

std::ptrdiff_t OpenFile::read(std::span<std::byte> bytes) const
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t more = ::read(m_file, bytes.data() + done, bytes.size() - done);
        if (more < 0 && errno == EINTR)
            continue;
        if (more < 0)
            return -1;
        if (more == 0)
            break;
        done += static_cast<std::size_t>(more);
    }
    return static_cast<std::ptrdiff_t>(done);
}

} // namespace carina
