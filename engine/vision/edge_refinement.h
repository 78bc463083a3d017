#pragma once

#include "engine/vision/camera_model.h"
#include "engine/vision/grey_picture.h"

#include <array>

namespace carina
{

/// The corners of a black square on white, from corners that are right to about a pixel: along each
/// edge the place of the steepest rise from inside to outside is measured on many lines across it,
/// a straight line is fitted to these places, outliers left out, and neighbouring lines are
/// intersected. It is exact to a few hundredths of a pixel where the edges are straight and sharp.
///
/// A corner stays as it was where an edge has too few such places, or would move it by more than
/// three pixels.
/// @param corners in pixels, in either direction around the square
/// @param cells   of the marker along a side, which bounds how far from an edge it is looked
[[nodiscard]] std::array<Vec2, 4> refinedCorners(const GreyPicture& picture,
                                                 const std::array<Vec2, 4>& corners, int cells);

} // namespace carina
