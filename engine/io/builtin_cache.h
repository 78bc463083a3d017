#pragma once

#include "engine/anatomy/builtin_patient.h"
#include "engine/io/anatomy_cache.h"

namespace carina
{

/// A built-in patient: from the cache where it was kept, else made and kept there for the next
/// time, which is the same patient. Where it cannot be kept it is made again.
///
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @returns MeshNotClosed, see builtinPatient.
[[nodiscard]] Result<Anatomy> cachedBuiltinPatient(BuiltinPatient patient,
                                                   const std::filesystem::path& cacheFolder);

} // namespace carina
