#pragma once

#include "engine/display/eye_view.h"

namespace carina
{

/// A rectangle of a window, in shares of its width and height, from its upper left corner.
struct WindowPart {
    double x = 0.0;
    double y = 0.0;
    double width = 1.0;
    double height = 1.0;
};

/// A rectangle of a window in whole pixels, from its upper left corner.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// The view of one eye, and the part of a window in which it is drawn.
struct EyePicture {
    RigidTransform X_AD; ///< pose of the eye in the anatomy frame A
    Frustum frustum;
    WindowPart part; ///< within which the picture is letterboxed
};

/// The pixels of a window's part, with each edge rounded to the nearest pixel boundary, so that
/// parts that share an edge do not share a pixel.
/// @pre width and height of the window are above 0, and the part lies within it.
[[nodiscard]] PixelRect pixelsOf(const WindowPart& part, int windowWidth, int windowHeight);

/// The pixels into which a picture is drawn, and its frustum.
struct PlacedPicture {
    PixelRect pixels;
    Frustum frustum; ///< that of exactly these pixels
};

/// The largest picture with the aspect ratio of the frustum, centred in an area. As its edges
/// rarely fall on pixel boundaries, it is drawn into all pixels that it touches (at least one), and
/// the frustum is widened by the parts of these pixels beyond its edges. So pixels are square, and
/// rounding moves no point of the picture.
/// @pre width and height of the area are above 0; right > left and top > bottom in the frustum.
[[nodiscard]] PlacedPicture letterboxed(const Frustum& frustum, const PixelRect& area);

} // namespace carina
