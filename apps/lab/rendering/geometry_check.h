#pragma once

#include "apps/lab/rendering/headset_series.h"

namespace carina::lab
{

/// How far balls were drawn from where they should be seen.
struct GeometryErrors {
    int measured = 0; ///< once for each ball and eye
    int outside = 0;  ///< left out: cut by the picture's edge, or not in the picture
    int touching = 0; ///< left out: touching another ball in the picture
    int notDrawn = 0; ///< should have been seen, and no pixel shows them
    double largest_px = 0.0;
    double mean_px = 0.0;
    int smallestBall_px = 0; ///< pixels of the ball that covers fewest
};

/// Draws a small ball at each of several places in and about a patient with the view that headsets
/// use, side by side, for every pose with every geometry, and holds the middle of the pixels of
/// each ball in each eye's half against the line from the eye to the ball.
///
/// @returns NoGraphics without OpenGL 3.3, or where nothing comes back from it.
/// @pre both counts of the trial are above zero, there is a QApplication, and prepareGraphics() was
/// called before it was made.
[[nodiscard]] Result<GeometryErrors> checkGeometry(const AirwayLandmarks& airway,
                                                   const GeometryTrial& trial);

} // namespace carina::lab
