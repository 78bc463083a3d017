#include "engine/io/anatomy_set/anatomy_cache.h"

#include "engine/io/anatomy_set/set_codec.h"
#include "engine/io/anatomy_set/set_description.h"
#include "engine/io/anatomy_set/set_hash.h"
#include "engine/io/files/mapped_file.h"
#include "engine/io/files/whole_file.h"

#include <QJsonDocument>
#include <QStandardPaths>

#include <algorithm>
#include <span>

namespace carina
{
AnatomyCache::AnatomyCache(std::filesystem::path folder) : m_folder(std::move(folder)) {}

std::filesystem::path AnatomyCache::defaultFolder()
{
    const QString caches = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    return std::filesystem::path{caches.toStdString()} / "carina" / "anatomy";
}

std::filesystem::path AnatomyCache::setFile(const std::string& contentHash) const
{
    return m_folder / (contentHash + ".anatomy");
}

std::optional<std::string> AnatomyCache::contentHash(const std::string& listingHash) const
{
    const Result<std::string> hash =
        readWholeFile(m_folder / (listingHash + ".listing"), kDescriptionLimit);
    if (!hash || !isSetHash(*hash))
        return std::nullopt;
    return *hash;
}

Result<ImportedSet> AnatomyCache::load(const std::string& contentHash) const
{
    const std::filesystem::path file = setFile(contentHash);
    const Result<MappedFile> mapped = MappedFile::of(file, kCachedSetLimit);
    if (!mapped)
        return tl::unexpected(mapped.error());
    auto set = decodeSet(mapped->bytes());
    if (!set)
        return fail(set.error().code, file.string() + ": " + set.error().detail);
    if (set->anatomy.contentHash != contentHash)
        return fail(Errc::FileMalformed, file.string() + ": it holds another set");
    return set;
}

Result<void> AnatomyCache::remember(const std::string& listingHash,
                                    const std::string& contentHash) const
{
    return writeWholeFile(m_folder / (listingHash + ".listing"), contentHash);
}

Result<void> AnatomyCache::store(const ImportedSet& set) const
{
    const std::string& hash = set.anatomy.contentHash;
    const std::vector<std::byte> bytes = encodeSet(set);
    const QByteArray description = QJsonDocument{describeSet(set)}.toJson();
    if (auto written = writeWholeFile(setFile(hash),
                                      {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        !written)
        return written;
    return writeWholeFile(m_folder / (hash + ".json"), description.toStdString());
}

Result<void> AnatomyCache::store(const ImportedSet& set, const std::string& listingHash) const
{
    return store(set).and_then(
        [&]() -> Result<void> { return remember(listingHash, set.anatomy.contentHash); });
}

} // namespace carina
