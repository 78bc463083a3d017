#pragma once

#include "engine/core/result.h"
#include "engine/geometry/mesh/vertex_color.h"

#include <string_view>
#include <vector>

namespace carina
{

/// A picture: rows from the top, each from the left.
struct Picture {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Rgb> pixels; ///< width x height
};

/// Decodes a PNG or JPEG file; transparency is ignored.
///
/// @returns UnknownFormat for bytes of another format; FileMalformed where they are damaged or
///          truncated, or the header declares more than 2^26 pixels.
///
/// A damaged picture can crash the library that decodes it. Therefore only carina-surface-reader
/// calls this.
[[nodiscard]] Result<Picture> decodePicture(std::string_view bytes);

} // namespace carina
