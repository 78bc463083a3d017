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
    Allowed, ///< a cached set is taken where there is one
    Renewed, ///< the files are read again and the cache is written anew
};

/// A set and how it came.
struct LoadedSet {
    ImportedSet set;
    bool fromCache = false;
    std::filesystem::path cacheFile; ///< where it is kept
    std::optional<Error> cacheFault; ///< why it could not be kept; the set is good all the same
};

/// A patient from a folder of surfaces: from the cache when its files look as they did last time,
/// or hold what a cached set was made from, else by importSetFolder, and kept for the next time.
/// Writes into the cache's folder and nowhere else.
///
/// What a review corrects is kept beside the cache, as <content hash of the
/// files>.corrections.json, and holds for the same files from then on; who has a review sees it
/// already corrected.
///
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @param progress may be empty
/// @param review may be empty; asked only where files are read
/// @returns FileNotFound without such a folder; NothingRecognised; OutOfRange; Cancelled.
[[nodiscard]] Result<LoadedSet> loadAnatomySet(const std::filesystem::path& folder,
                                               const std::filesystem::path& cacheFolder,
                                               const ImportProgress& progress = {},
                                               CacheUse use = CacheUse::Allowed,
                                               const SetReview& review = {});

} // namespace carina
