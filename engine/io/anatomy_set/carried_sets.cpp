#include "engine/io/anatomy_set/carried_sets.h"

#include "engine/core/expects.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/anatomy_set/set_check.h"
#include "engine/io/anatomy_set/set_codec.h"
#include "engine/io/anatomy_set/set_hash.h"
#include "engine/io/files/whole_file.h"

#include <QCryptographicHash>

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
    const Result<std::string> text = readWholeFile(file);
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

} // namespace carina
