#include "engine/io/files/file_limit.h"

#include "engine/io/files/open_file.h"

namespace carina
{
namespace
{

/// Rounded up, so that a file that is too large never seems to have just the size allowed.
std::string mebibytes(std::uint64_t bytes)
{
    return std::to_string(bytes / kMebibyte + (bytes % kMebibyte == 0 ? 0 : 1)) + " MiB";
}

} // namespace

Result<void> checkSize(const std::filesystem::path& file, std::uint64_t bytes,
                       const FileLimit& limit)
{
    if (bytes <= limit.mostBytes)
        return {};
    return fail(Errc::FileTooLarge, file.string() + ": it has " + mebibytes(bytes) + ", and "
                                        + limit.kind + " may have " + mebibytes(limit.mostBytes));
}

Result<std::uint64_t> readableSize(const std::filesystem::path& file, const FileLimit& limit)
{
    return OpenFile::of(file, limit).map([](const OpenFile& opened) { return opened.size(); });
}

} // namespace carina
