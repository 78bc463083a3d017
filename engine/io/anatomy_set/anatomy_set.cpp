#include "engine/io/anatomy_set/anatomy_set.h"

#include "engine/io/anatomy_set/set_folder.h"
#include "engine/io/anatomy_set/set_import.h"

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

/// A cached set for the folder, or what a new one is made with.
struct Lookup {
    std::optional<LoadedSet> found;
    std::string filesHash;
    SetCorrections corrections{};
};

std::filesystem::path correctionsFile(const std::filesystem::path& cacheFolder,
                                      const std::string& filesHash)
{
    return cacheFolder / (filesHash + ".corrections.json");
}

Lookup lookUp(const AnatomyCache& cache, const std::filesystem::path& cacheFolder,
              const SetFolder& folder, const std::string& listingHash, CacheUse use)
{
    const bool allowed = use == CacheUse::Allowed;
    if (const auto known = allowed ? cache.contentHash(listingHash) : std::nullopt)
        if (auto found = fromCache(cache, *known))
            return {std::move(found), *known};
    Lookup lookup{std::nullopt, contentHashOf(folder)};
    if (auto kept = readCorrections(correctionsFile(cacheFolder, lookup.filesHash)))
        lookup.corrections = std::move(*kept);
    if (!allowed)
        return lookup;
    const std::string hash = correctedHash(lookup.filesHash, lookup.corrections);
    lookup.found = fromCache(cache, hash);
    if (lookup.found)
        if (const auto kept = cache.remember(listingHash, hash); !kept)
            lookup.found->cacheFault = kept.error();
    return lookup;
}

/// Shows a draft as corrected before, and adds what is corrected now.
SetReview reviewWith(SetCorrections& corrections, const SetReview& review)
{
    return [&corrections, &review](const SetDraft& draft) -> std::optional<SetCorrections> {
        if (!review)
            return corrections;
        SetDraft shown = draft;
        for (DraftSurface& surface : shown.surfaces)
            if (const auto known = corrections.roles.find(surface.key);
                known != corrections.roles.end())
                surface.role = known->second;
        if (corrections.frame)
            shown.frame = corrections.frame;
        auto more = review(shown);
        if (!more)
            return std::nullopt;
        more->roles.merge(corrections.roles);
        if (!more->frame)
            more->frame = corrections.frame;
        corrections = std::move(*more);
        return corrections;
    };
}

Result<void> keep(const AnatomyCache& cache, const std::filesystem::path& cacheFolder,
                  const Lookup& lookup, const ImportedSet& set, const std::string& listingHash)
{
    if (!lookup.corrections.empty())
        if (auto kept = writeCorrections(correctionsFile(cacheFolder, lookup.filesHash),
                                         lookup.corrections);
            !kept)
            return kept;
    return cache.store(set, listingHash);
}

} // namespace

Result<LoadedSet> loadAnatomySet(const std::filesystem::path& folder,
                                 const std::filesystem::path& cacheFolder,
                                 const ImportProgress& progress, CacheUse use,
                                 const SetReview& review)
{
    const auto files = listSetFolder(folder);
    if (!files)
        return tl::unexpected(files.error());
    const AnatomyCache cache{cacheFolder};
    const std::string listingHash = listingHashOf(*files);
    Lookup lookup = lookUp(cache, cacheFolder, *files, listingHash, use);
    if (lookup.found) {
        lookup.found->set.anatomy.name = nameOf(*files);
        return std::move(*lookup.found);
    }
    auto imported = importSetFolder(
        *files, progress ? progress : [](double) { return true; },
        reviewWith(lookup.corrections, review));
    if (!imported)
        return tl::unexpected(imported.error());
    imported->anatomy.name = nameOf(*files);
    imported->anatomy.contentHash = correctedHash(lookup.filesHash, lookup.corrections);
    LoadedSet loaded{std::move(*imported), false, {}, std::nullopt};
    loaded.cacheFile = cache.setFile(loaded.set.anatomy.contentHash);
    if (const auto kept = keep(cache, cacheFolder, lookup, loaded.set, listingHash); !kept)
        loaded.cacheFault = kept.error();
    return loaded;
}

} // namespace carina
