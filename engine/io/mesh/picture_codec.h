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

/// Decodes a PNG or JPEG file. What is transparent in it is opaque here.
///
/// @returns UnknownFormat for bytes of another kind; FileMalformed where they are damaged or
///          truncated, or promise more than 2^26 pixels.
///
/// A damaged picture can bring down the library that decodes it: called by carina-surface-reader
/// alone.
[[nodiscard]] Result<Picture> decodePicture(std::string_view bytes);

} // namespace carina
