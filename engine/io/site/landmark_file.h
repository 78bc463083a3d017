#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

namespace carina
{

/// A catalogue as the fields of a JSON object, and back:
///
///     "name": "Rib cage", "anatomy": "<content hash>" (may be left out),
///     "landmarks": [{"name": "Sternal notch", "p_AQ_mm": [0, -60, 36]}, ...]
///
/// Reading refuses through `fields` what checkCatalogue refuses.
[[nodiscard]] QJsonObject jsonCatalogue(const LandmarkCatalogue& catalogue);
[[nodiscard]] LandmarkCatalogue readCatalogue(JsonFields& fields);

/// Reads a landmark file: a catalogue with "schema": "carina.landmarks/1".
/// @returns what readJsonFile returns; FileMalformed where a field is missing, of the wrong kind or
///          unknown, or the catalogue cannot be used. The detail names file, field and fault.
[[nodiscard]] Result<LandmarkCatalogue> readLandmarkFile(const std::filesystem::path& file);

/// Writes one, whole or not at all.
/// @returns what checkCatalogue returns; FileUnwritable
[[nodiscard]] Result<void> writeLandmarkFile(const std::filesystem::path& file,
                                             const LandmarkCatalogue& catalogue);

} // namespace carina
