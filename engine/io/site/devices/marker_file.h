#pragma once

#include "engine/core/result.h"
#include "engine/vision/marker_body.h"
#include "engine/vision/marker_dictionary.h"

#include <filesystem>

namespace carina
{

/// What a camera has to know of a tool: the markers that it wears.
struct MarkedBody {
    MarkerDictionary dictionary = MarkerDictionary::Bits4Of50;
    MarkerBody markers;
};

/// Reads the markers of a body: a JSON object with
///
///     schema      "carina.markers/1"
///     dictionary  "4x4_50" and the like (kDictionaryWords)
///     markers     a list of id, side_mm of the black square, and X_BK_mm, the marker in the frame
///                 of the body (BodyMarker): four rows of four numbers
///
/// @returns the errors of readJsonFile; FileMalformed for a fault, and for a body that fails
///          checkBody. The detail names file and field.
[[nodiscard]] Result<MarkedBody> readMarkerFile(const std::filesystem::path& file);

/// @returns FileUnwritable
[[nodiscard]] Result<void> writeMarkerFile(const std::filesystem::path& file,
                                           const MarkedBody& body);

} // namespace carina
