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

} // namespace carina
