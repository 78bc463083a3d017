#include "engine/io/anatomy_set/carried_sets.h"

#include "engine/core/expects.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/anatomy_set/set_check.h"
#include "engine/io/anatomy_set/set_codec.h"
#include "engine/io/anatomy_set/set_hash.h"
#include "engine/io/files/whole_file.h"

#include <QCryptographicHash>
#include <QFile>

#include <algorithm>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace carina
{
namespace
{

std::string digestOf(std::span<const std::byte> bytes)
{
    QCryptographicHash hash{QCryptographicHash::Blake2b_256};
    hash.addData(QByteArrayView{bytes.data(), static_cast<qsizetype>(bytes.size())});
    return hash.result().toHex().toStdString();
}

/// The lines, one below the other, without the end of a text that is too long.
std::string licenceOf(const Anatomy& anatomy)
{
    std::string text;
    for (const std::string& line : anatomy.attributions)
        text += (text.empty() ? "" : "\n") + line;
    std::size_t length = std::min(text.size(), CarriedSets::kLongestLicence);
    const auto goesOnInUtf8 = [](char c) { return (static_cast<unsigned char>(c) >> 6U) == 2U; };
    while (length > 0 && length < text.size() && goesOnInUtf8(text[length]))
        --length;
    text.resize(length);
    return text;
}

bool isThere(const std::filesystem::path& file, std::uint64_t bytes)
{
    std::error_code error;
    return std::filesystem::file_size(file, error) == bytes && !error;
}

tl::unexpected<Error> cannotWrite(const std::filesystem::path& file, const std::string& why)
{
    return fail(Errc::FileUnwritable, file.string() + ": " + why);
}

std::string digestOfFile(int file)
{
    QFile source;
    QCryptographicHash hash{QCryptographicHash::Blake2b_256};
    if (!source.open(file, QIODevice::ReadOnly) || !source.seek(0) || !hash.addData(&source))
        return {};
    return hash.result().toHex().toStdString();
}

/// An open file that nobody else writes; -1 where there is none, -2 where somebody does.
int openLocked(const std::filesystem::path& file)
{
    const int opened = open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (opened < 0)
        return -1;
    if (flock(opened, LOCK_EX | LOCK_NB) != 0) {
        close(opened);
        return -2;
    }
    return opened;
}

} // namespace

CarriedSets::CarriedSets(std::filesystem::path cacheFolder, RoomIn roomIn)
    : m_cacheFolder{std::move(cacheFolder)}, m_roomIn{roomIn}
{
}

std::uint64_t CarriedSets::roomOnDisk(const std::filesystem::path& folder)
{
    std::error_code error;
    // Where it is not known the writing will tell.
    return std::filesystem::space(folder, error).available;
}

std::filesystem::path CarriedSets::file(const std::string& digest) const
{
    CARINA_EXPECTS(isSetHash(digest));
    return m_cacheFolder / "carried" / (digest + ".anatomy");
}

bool CarriedSets::has(const CarriedSet& set) const { return isThere(file(set.digest), set.bytes); }

Result<CarriedSet> CarriedSets::prepare(const std::string& contentHash) const
{
    if (!isSetHash(contentHash))
        return fail(Errc::FileNotFound, contentHash);
    auto set = AnatomyCache{m_cacheFolder}.load(contentHash);
    if (!set)
        return tl::unexpected(set.error());
    // They name folders of this computer.
    set->faults.clear();
    set->leftOut.clear();
    const std::vector<std::byte> bytes = encodeSet(*set);
    if (bytes.size() > kMostBytes)
        return fail(Errc::OutOfRange, "a set of " + std::to_string(bytes.size() >> 20U)
                                          + " MiB; at most " + std::to_string(kMostBytes >> 20U)
                                          + " MiB travel");
    CarriedSet carried{digestOf(bytes), bytes.size(), licenceOf(set->anatomy)};
    if (has(carried))
        return carried;
    const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    return writeWholeFile(file(carried.digest), text).map([&] { return carried; });
}

Result<ImportedSet> CarriedSets::load(const std::string& digest,
                                      const std::string& contentHash) const
{
    const std::filesystem::path file = this->file(digest);
    const Result<std::string> text = readWholeFile(file, kCarriedSetLimit);
    if (!text)
        return tl::unexpected(text.error());
    const auto bytes = std::as_bytes(std::span{*text});
    if (digestOf(bytes) != digest)
        return fail(Errc::FileMalformed, file.string() + ": it was changed");
    auto set = decodeSet(bytes);
    if (!set)
        return fail(set.error().code, file.string() + ": " + set.error().detail);
    if (set->anatomy.contentHash != contentHash)
        return fail(Errc::FileMalformed, file.string() + ": it holds another set");
    if (const auto sound = checkSet(*set); !sound)
        return fail(sound.error().code, file.string() + ": " + sound.error().detail);
    return set;
}

Result<std::unique_ptr<PartialSet>> CarriedSets::resume(const CarriedSet& set) const
{
    CARINA_EXPECTS(set.bytes > 0 && set.bytes <= kMostBytes);
    const std::filesystem::path whole = file(set.digest);
    const std::filesystem::path part = std::filesystem::path{whole}.replace_extension(".part");
    std::error_code error;
    std::filesystem::create_directories(part.parent_path(), error);
    const int opened = openLocked(part);
    if (opened == -2)
        return nullptr;
    if (opened >= 0 && has(set)) { // the other program finished it just now
        close(opened);
        return nullptr;
    }
    struct stat found {
    };
    if (opened < 0 || fstat(opened, &found) != 0)
        return cannotWrite(part, "cannot be written");
    auto bytes = static_cast<std::uint64_t>(found.st_size);
    if (bytes > set.bytes && ftruncate(opened, 0) == 0)
        bytes = 0;
    std::unique_ptr<PartialSet> partial{new PartialSet{opened, bytes, part, whole, set.digest}};
    if (m_roomIn(part.parent_path()) < set.bytes - bytes)
        return cannotWrite(part, "the disk has no room for it");
    return partial;
}

PartialSet::PartialSet(int file, std::uint64_t bytes, std::filesystem::path part,
                       std::filesystem::path whole, std::string digest)
    : m_file{file},
      m_bytes{bytes},
      m_part{std::move(part)},
      m_whole{std::move(whole)},
      m_digest{std::move(digest)}
{
}

PartialSet::~PartialSet() { close(m_file); }

Result<void> PartialSet::append(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = write(m_file, bytes.data(), bytes.size());
        if (written <= 0)
            return cannotWrite(m_part, "cannot be written");
        m_bytes += static_cast<std::uint64_t>(written);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

Result<void> PartialSet::finish()
{
    std::error_code error;
    if (digestOfFile(m_file) != m_digest) {
        std::filesystem::remove(m_part, error);
        return fail(Errc::FileMalformed, m_part.string() + ": what came is not what was promised");
    }
    if (fsync(m_file) == 0)
        std::filesystem::rename(m_part, m_whole, error);
    else
        error = std::make_error_code(std::errc::io_error);
    if (error)
        return cannotWrite(m_whole, "cannot be written");
    return {};
}

} // namespace carina
