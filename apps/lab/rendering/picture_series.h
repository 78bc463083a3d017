#pragma once

#include "engine/core/result.h"
#include "widgets/scene/view/scene_view.h"

#include <functional>

namespace carina::lab
{

/// Frames of a scene to be drawn one after another, each for a picture.
struct PictureSeries {
    std::size_t count = 0;
    QSize size; ///< of every picture, pixels
    /// Gives the view its parts before anything is drawn.
    std::function<void(SceneView&)> prepare;
    /// A frame by its number; may turn the view's camera.
    std::function<SceneFrame(SceneView&, std::size_t)> frame;
    /// Gets the picture of each, while the view shows it; a failure ends the series.
    std::function<Result<void>(SceneView&, std::size_t, const QImage&)> take;
};

/// Draws a series in a window of its own, the scene that all programs have, each picture with one
/// sample per pixel unless the series fixes another quality, so that it is the same every time.
///
/// @returns NoGraphics without OpenGL 3.3, or where a picture does not come within a minute; what
///          `take` fails with.
/// @pre there is a QApplication, its event loop is not running, and nothing is empty.
[[nodiscard]] Result<void> drawSeries(const PictureSeries& series);

} // namespace carina::lab
