#pragma once

#include "widgets/scene/view/scene_frame.h"

namespace carina
{

/// Whether both frames are drawn alike, by the values that the shaders get, whatever their times
/// are. Frames that are not shown from the same eyes differ.
[[nodiscard]] bool areDrawnAlike(const SceneFrame& a, const SceneFrame& b);

} // namespace carina
