#pragma once

#include "engine/geometry/vec.h"

namespace carina
{

/// Eyes and screen of a headset, in the head frame H (+x to the right, +y up, looking along -z),
/// metres. The screen is parallel to the x and y axes of H; both eyes see the same screen.
struct DisplayGeometry {
    Vec3 p_HDl = Vec3::Zero(); ///< left eye
    Vec3 p_HDr = Vec3::Zero(); ///< right eye
    Vec3 p_HQ_screenCentre = Vec3::Zero();
    double screenWidth = 0.0;
    double screenHeight = 0.0;
};

/// The display of a site that has not measured its own: an optical see-through headset with eyes
/// 63 mm apart, symmetric about the origin of H, and the virtual image of a 4:3 display 1 m ahead
/// that spans 52 degrees along its diagonal, as the projection optics of Hua et al. (Applied Optics
/// 39, 2000) and their successors.
[[nodiscard]] DisplayGeometry defaultDisplay();

} // namespace carina
