#pragma once

#include "engine/vision/camera_model.h"
#include "engine/vision/grey_picture.h"
#include "engine/vision/marker_dictionary.h"

#include <array>
#include <vector>

namespace carina
{

/// A marker in a picture.
struct DetectedMarker {
    int id = 0;
    /// Pixels, in the order of cornersOf(BodyMarker): it follows the printed picture, however the
    /// marker is turned.
    std::array<Vec2, 4> corners;
};

/// All markers of a dictionary in a picture, found by OpenCV, with corners where the lines through
/// their refined edges meet (refinedCorners).
[[nodiscard]] std::vector<DetectedMarker> seenMarkers(const GreyPicture& picture,
                                                      MarkerDictionary dictionary);

} // namespace carina
