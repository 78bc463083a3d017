#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

namespace carina
{

/// A catalogue as a JSON object, and back:
///
///     "name": "Rib cage", "anatomy": "<content hash>" (may be left out),
///     "landmarks": [{"name": "Sternal notch", "p_AQ_mm": [0, -60, 36]}, ...]
///
/// Reading reports errors of checkCatalogue as faults of `fields`.
[[nodiscard]] QJsonObject jsonCatalogue(const LandmarkCatalogue& catalogue);
[[nodiscard]] LandmarkCatalogue readCatalogue(JsonFields& fields);

/// Reads a landmark file: a catalogue with "schema": "carina.landmarks/1".
/// @returns the errors of readJsonFile; FileMalformed where a field is missing, of the wrong type
///          or unknown, or the catalogue is invalid. The detail names file, field and fault.
[[nodiscard]] Result<LandmarkCatalogue> readLandmarkFile(const std::filesystem::path& file);

/// Writes a landmark file atomically.
/// @returns the errors of checkCatalogue; FileUnwritable
[[nodiscard]] Result<void> writeLandmarkFile(const std::filesystem::path& file,
                                             const LandmarkCatalogue& catalogue);

} // namespace carina
