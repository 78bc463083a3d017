#include "engine/io/anatomy_set.h"

#include "engine/io/set_folder.h"
#include "engine/io/set_import.h"

namespace carina
{
namespace
{

std::string nameOf(const SetFolder& folder)
{
    std::error_code error;
    const auto path = std::filesystem::absolute(folder.root, error).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::optional<LoadedSet> fromCache(const AnatomyCache& cache, const std::string& hash)
{
    auto set = cache.load(hash);
    if (!set)
        return std::nullopt;
    return LoadedSet{std::move(*set), true, cache.setFile(hash), std::nullopt};
}

/// A cached set for the folder, or the content hash that a new one gets.
struct Lookup {
    std::optional<LoadedSet> found;
    std::string contentHash;
};

Lookup lookUp(const AnatomyCache& cache, const SetFolder& folder, const std::string& listingHash)
{
    if (const auto known = cache.contentHash(listingHash))
        if (auto found = fromCache(cache, *known))
            return {std::move(found), *known};
    std::string hash = contentHashOf(folder);
    auto found = fromCache(cache, hash);
    if (found)
        if (const auto kept = cache.remember(listingHash, hash); !kept)
            found->cacheFault = kept.error();
    return {std::move(found), std::move(hash)};
}

} // namespace

Result<LoadedSet> loadAnatomySet(const std::filesystem::path& folder,
                                 const std::filesystem::path& cacheFolder,
                                 const ImportProgress& progress, CacheUse use)
{
    const auto files = listSetFolder(folder);
    if (!files)
        return tl::unexpected(files.error());
    const AnatomyCache cache{cacheFolder};
    const std::string listingHash = listingHashOf(*files);
    Lookup lookup = use == CacheUse::Allowed ? lookUp(cache, *files, listingHash)
                                             : Lookup{std::nullopt, contentHashOf(*files)};
    if (lookup.found) {
        lookup.found->set.anatomy.name = nameOf(*files);
        return std::move(*lookup.found);
    }
    auto imported = importSetFolder(
        *files, progress ? progress : [](double) { return true; });
    if (!imported)
        return tl::unexpected(imported.error());
    imported->anatomy.name = nameOf(*files);
    imported->anatomy.contentHash = lookup.contentHash;
    LoadedSet loaded{std::move(*imported), false, cache.setFile(lookup.contentHash), std::nullopt};
    if (const auto kept = cache.store(loaded.set, listingHash); !kept)
        loaded.cacheFault = kept.error();
    return loaded;
}

} // namespace carina
