#pragma once

#include "engine/core/result.h"
#include "engine/display/display_geometry.h"
#include "engine/geometry/rigid_transform.h"

#include <cstdint>

namespace carina
{

/// Whose picture is drawn: one for each eye, or one for both, from midway between them.
enum class Eye : std::uint8_t { Left, Right, Middle };

/// What an eye sees through its screen: the screen's edges at unit distance before the eye, that is
/// the tangents of the angles to the line of sight. Negative left of it and below it; the four need
/// not be symmetric, nor lie about the line of sight at all.
struct Frustum {
    double left = -1.0;
    double right = 1.0;
    double bottom = -1.0;
    double top = 1.0;
};

/// An eye D and what it sees. D has the axes of H: +x to the right, +y up, line of sight along -z,
/// at a right angle to the screen.
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
///          width or height, for an eye behind the screen or less than 1 mm before it, and for
///          lengths so unlike each other that the tangents lose them.
[[nodiscard]] Result<EyeView> eyeView(const DisplayGeometry& display, Eye eye);

} // namespace carina
