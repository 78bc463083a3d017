#pragma once

#include "engine/core/result.h"
#include "engine/display/display_geometry.h"
#include "engine/geometry/rigid_transform.h"

#include <cstdint>

namespace carina
{

/// The eye for which a picture is drawn; Middle is one picture for both, from midway between them.
enum class Eye : std::uint8_t { Left, Right, Middle };

/// The off-axis frustum of an eye and its screen: the edges at unit distance from the eye, which
/// are the tangents of their angles to the line of sight (-z of D). Negative to the left of it and
/// below it. The frustum need be neither symmetric nor contain the line of sight.
struct Frustum {
    double left = -1.0;
    double right = 1.0;
    double bottom = -1.0;
    double top = 1.0;
};

/// The pose of an eye D and its frustum. D has the axes of H: +x to the right, +y up, line of sight
/// along -z, perpendicular to the screen.
struct EyeView {
    RigidTransform X_HD;
    Frustum frustum;
};

/// The view of one eye. With the eye at e and the screen's centre at c, both in H, the screen is
/// d = e_z - c_z ahead, and
///
///     left   = (c_x - e_x - width / 2) / d       right = (c_x - e_x + width / 2) / d
///     bottom = (c_y - e_y - height / 2) / d      top   = (c_y - e_y + height / 2) / d
///
/// @returns NotFinite where a number of the display is not finite; OutOfRange for a screen without
///          width or height, for an eye behind the screen or less than 1 mm in front of it, and
///          where the lengths differ so much that the frustum has no size in double precision.
[[nodiscard]] Result<EyeView> eyeView(const DisplayGeometry& display, Eye eye);

} // namespace carina
