#pragma once

#include "models/patient/patient_model.h"

#include <filesystem>
#include <memory>

namespace carina
{

/// Shared, because a scene draws one patient while the next is built on another thread.
using SharedPatientModel = std::shared_ptr<const PatientModel>;

/// A patient with its tube, whose size follows from the dimensions of a generated patient; an
/// imported patient gets an adult's. @returns the errors of PatientModel::of.
[[nodiscard]] Result<SharedPatientModel> patientOf(Anatomy anatomy);

/// The built-in, or previously imported, patient with this content hash. Takes about a second; may
/// be called from any thread.
/// @param name in the session
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @returns FileNotFound if there is none; the errors of reading and building it.
[[nodiscard]] Result<SharedPatientModel> patientHere(const std::string& contentHash,
                                                     const std::string& name,
                                                     const std::filesystem::path& cacheFolder);

/// The same for a set received from the host.
[[nodiscard]] Result<SharedPatientModel> patientCarried(const std::string& digest,
                                                        const std::string& contentHash,
                                                        const std::string& name,
                                                        const std::filesystem::path& cacheFolder);

} // namespace carina
