#pragma once

#include "models/patient/patient_model.h"

#include <filesystem>
#include <memory>

namespace carina
{

/// Shared: a scene goes on drawing one patient while the next is made on another thread.
using SharedPatientModel = std::shared_ptr<const PatientModel>;

/// A patient with the tube that goes with it: of the figures that a patient was made from, or,
/// for an imported one, of an adult. @returns what PatientModel::of does.
[[nodiscard]] Result<SharedPatientModel> patientOf(Anatomy anatomy);

/// The patient with this content hash that is built in, or was imported on this computer. Takes a
/// second; may be called from any thread.
/// @param name that the session gives it @param cacheFolder usually AnatomyCache::defaultFolder()
/// @returns FileNotFound where there is none; what reading or building it fails with.
[[nodiscard]] Result<SharedPatientModel> patientHere(const std::string& contentHash,
                                                     const std::string& name,
                                                     const std::filesystem::path& cacheFolder);

/// The patient of a set that came from the host, likewise.
[[nodiscard]] Result<SharedPatientModel> patientCarried(const std::string& digest,
                                                        const std::string& contentHash,
                                                        const std::string& name,
                                                        const std::filesystem::path& cacheFolder);

} // namespace carina
