#pragma once

#include "engine/display/eye_view.h"

namespace carina
{

/// A part of a window, as shares of its width and height from its upper left corner.
struct WindowPart {
    double x = 0.0;
    double y = 0.0;
    double width = 1.0;
    double height = 1.0;
};

/// Whole pixels of a window, from its upper left corner.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// What one eye sees, and in which part of a window.
struct EyePicture {
    RigidTransform X_AD; ///< the eye in the anatomy
    Frustum frustum;
    WindowPart part; ///< within which the picture is letterboxed
};

/// The pixels of a window's part, each of whose edges falls on the nearest line between pixels; so
/// parts that share an edge share no pixel.
/// @pre the window has a size, and the part lies within it.
[[nodiscard]] PixelRect pixelsOf(const WindowPart& part, int windowWidth, int windowHeight);

/// A picture where it is drawn.
struct PlacedPicture {
    PixelRect pixels;
    Frustum frustum; ///< what is seen in these very pixels
};

/// The largest picture of a frustum's width over height, centred in an area. Its edges seldom lie
/// between two pixels: it is drawn into all pixels that it touches, at least one, and the frustum
/// is widened by what they show beyond its edges. So each pixel is as wide as it is high, and no
/// point of the picture is moved by rounding.
/// @pre the area has a size and the frustum's right and top are beyond its left and bottom.
[[nodiscard]] PlacedPicture letterboxed(const Frustum& frustum, const PixelRect& area);

} // namespace carina
