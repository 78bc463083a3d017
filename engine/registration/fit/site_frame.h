#pragma once

#include "engine/core/result.h"
#include "engine/geometry/rigid_transform.h"

#include <span>

namespace carina
{

/// The manikin's local frame M from its landmarks, as touched with the stylus:
///
///     origin  the mean of all points
///     +z      from the second point to the first
///     +x      perpendicular to +z, towards the side of this line on which the third point lies
///     +y      z cross x
///
/// With the rib cage's landmarks in their order (sternal notch, xiphoid process, left fifth rib,
/// right fifth rib) +x is the manikin's left, +y posterior and +z superior; the rotation from A is
/// about that of the sternum's slope.
///
/// @param p_TQ the landmarks in the tracker's frame, metres, in the order of their catalogue
/// @returns X_TM; TooFewLandmarks below three; DegenerateLandmarks where the first three are
///          coincident or (nearly) collinear; NotFinite; OutOfRange for a kilometre or more.
[[nodiscard]] Result<RigidTransform> siteFrame(std::span<const Vec3> p_TQ);

} // namespace carina
