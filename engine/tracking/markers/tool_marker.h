#pragma once

#include "engine/geometry/vec.h"

namespace carina
{

/// A marker Q of a tool O.
struct ToolMarker {
    Vec3 p_OQ = Vec3::Zero();     ///< metres
    Vec3 normal_O = Vec3::Zero(); ///< where it faces; zero where it is seen from everywhere
};

} // namespace carina
