#pragma once

#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/anatomy_set/imported_set.h"
#include "engine/io/anatomy_set/set_corrections.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace carina
{

enum class CacheUse : std::uint8_t {
    Allowed, ///< a cached set is used where there is one
    Renewed, ///< the files are read again and the cache is rewritten
};

/// A set and where it was loaded from.
struct LoadedSet {
    ImportedSet set;
    bool fromCache = false;
    std::filesystem::path cacheFile; ///< its file in the cache
    std::optional<Error> cacheFault; ///< why it could not be cached; the set is valid all the same
};

/// A patient from a folder of surfaces: from the cache where the listing or the content of the
/// files is that of a cached set, else by importSetFolder, and stored in the cache. Writes into the
/// cache's folder only.
///
/// Corrections of a review are stored beside the cache, as <content hash of the
/// files>.corrections.json, and apply to the same files from then on; a later review is shown the
/// corrected draft.
///
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @param progress may be empty
/// @param review may be empty; called only where files are read
/// @returns FileNotFound without such a folder; NothingRecognised; OutOfRange; Cancelled.
[[nodiscard]] Result<LoadedSet> loadAnatomySet(const std::filesystem::path& folder,
                                               const std::filesystem::path& cacheFolder,
                                               const ImportProgress& progress = {},
                                               CacheUse use = CacheUse::Allowed,
                                               const SetReview& review = {});

} // namespace carina
