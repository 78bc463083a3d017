#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/io/anatomy_set/anatomy_cache.h"

namespace carina
{

/// The patient generated from these parameters: from the cache where it is stored, else generated
/// and stored. Both are identical. A failure to store is ignored. In Posture::Rest it has a content
/// hash too, by which heldJaw knows no patient: the mouth is shut.
///
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @returns OutOfRange and MeshNotClosed, see patientFor.
[[nodiscard]] Result<Anatomy> cachedPatient(const PatientParameters& parameters,
                                            const std::filesystem::path& cacheFolder,
                                            Posture posture = Posture::Laryngoscopy);

} // namespace carina
