#pragma once

#include "engine/core/result.h"
#include "widgets/scene/view/scene_view.h"

#include <QSize>

#include <functional>

namespace carina::lab
{

/// A scene that is drawn again and again.
struct TimedScene {
    QSize size; ///< of the picture, pixels
    /// Gives the view its parts before anything is drawn.
    std::function<void(SceneView&)> prepare;
    std::function<SceneFrame()> frame;
};

/// How many frames of a scene are drawn in a second, one after the other in a window of its own,
/// over some hundred of them.
///
/// @returns NoGraphics without OpenGL 3.3, or where a frame does not come within a minute
/// @pre as drawSeries; `prepare` fixes the quality, so that each is drawn
[[nodiscard]] Result<double> drawingRate(const TimedScene& scene);

} // namespace carina::lab
