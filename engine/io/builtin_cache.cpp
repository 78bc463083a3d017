#include "engine/io/builtin_cache.h"

#include <string>
#include <utility>

namespace carina
{

Result<Anatomy> cachedBuiltinPatient(BuiltinPatient patient,
                                     const std::filesystem::path& cacheFolder)
{
    const AnatomyCache cache{cacheFolder};
    if (auto kept = cache.load(std::string{builtinHash(patient)}))
        return std::move(kept->anatomy);
    return builtinPatient(patient).map([&](Anatomy&& made) {
        ImportedSet set{.anatomy = std::move(made), .frame = {}, .faults = {}, .leftOut = {}};
        static_cast<void>(cache.store(set)); // it can be made again
        return std::move(set.anatomy);
    });
}

} // namespace carina
