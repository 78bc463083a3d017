#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/io/anatomy_set/anatomy_cache.h"

namespace carina
{

/// The patient that these figures make: from the cache where it was kept, else made and kept there
/// for the next time, which is the same patient. Where it cannot be kept it is made again.
///
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @returns OutOfRange and MeshNotClosed, see patientFor.
[[nodiscard]] Result<Anatomy> cachedPatient(const PatientParameters& parameters,
                                            const std::filesystem::path& cacheFolder);

} // namespace carina
