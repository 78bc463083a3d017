#include "engine/io/files/whole_file.h"

#include "engine/io/files/open_file.h"

#include <QSaveFile>
#include <QString>
#include <QTemporaryFile>

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace carina
{
namespace
{

/// An empty path, such as above a bare file name, is the current folder.
std::error_code makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    if (!folder.empty())
        std::filesystem::create_directories(folder, error);
    return error;
}

/// A new name in a folder is only on the disk once the folder is. Some file systems cannot sync a
/// folder, and one may be closed to reading.
bool syncFolder(const std::filesystem::path& folder)
{
    const int opened =
        open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0)
        return errno == EACCES;
    const bool synced = fsync(opened) == 0 || errno == EINVAL;
    close(opened);
    return synced;
}

} // namespace

Result<std::string> readWholeFile(const std::filesystem::path& file, const FileLimit& limit)
{
    const auto opened = OpenFile::of(file, limit);
    if (!opened)
        return tl::unexpected(opened.error());
    std::string bytes(static_cast<std::size_t>(opened->size()), '\0');
    if (opened->read(std::as_writable_bytes(std::span{bytes})) != std::ptrdiff_t(bytes.size()))
        return fail(Errc::FileUnreadable, file.string() + ": cannot be read whole");
    return bytes;
}

Result<void> writeWholeFile(const std::filesystem::path& file, std::string_view bytes)
{
    const std::error_code error = makeFolder(file.parent_path());
    QSaveFile target{QString::fromStdString(file.string())};
    const auto size = static_cast<qint64>(bytes.size());
    if (error || !target.open(QIODevice::WriteOnly) || target.write(bytes.data(), size) != size
        || !target.commit() || !syncFolder(file.parent_path()))
        return fail(Errc::FileUnwritable, file.string() + ": cannot be written");
    return {};
}

Result<void> writePrivateFile(const std::filesystem::path& file, std::string_view bytes)
{
    std::error_code error = makeFolder(file.parent_path());
    // QTemporaryFile opens its file with mode 0600.
    QTemporaryFile target{QString::fromStdString(file.string()) + QStringLiteral(".XXXXXX")};
    const auto size = static_cast<qint64>(bytes.size());
    const bool written = !error && target.open() && target.write(bytes.data(), size) == size
                         && target.flush() && fsync(target.handle()) == 0;
    if (!written)
        return fail(Errc::FileUnwritable, file.string() + ": cannot be written");
    target.setAutoRemove(false);
    return placeFile(target.fileName().toStdString(), file);
}

Result<void> placeFile(const std::filesystem::path& finished, const std::filesystem::path& file)
{
    std::error_code error;
    std::filesystem::rename(finished, file, error);
    if (!error && syncFolder(file.parent_path()))
        return {};
    std::filesystem::remove(finished, error);
    return fail(Errc::FileUnwritable, file.string() + ": cannot be written");
}

Result<void> openFolder(const std::filesystem::path& folder)
{
    const std::error_code error = makeFolder(folder);
    QTemporaryFile file{QString::fromStdString((folder / "carina").string())};
    if (error || !file.open())
        return fail(Errc::FileUnwritable, folder.string() + ": nothing can be written into it");
    return {};
}

} // namespace carina
