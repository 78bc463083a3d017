#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

namespace carina
{

/// Angle of a rotation, 0 to pi, as 2 atan2(|v|, |w|): exact near 0 where 2 acos(w) loses half its
/// digits, and never above pi although q and -q are the same rotation.
[[nodiscard]] Angle angleOf(const Quat& q);

/// Angle of q_s q_c^-1: the rotation between two sites' orientations of one object, 0 to pi.
[[nodiscard]] Angle angleBetween(const Quat& q_s, const Quat& q_c);

/// The same rotation as a unit quaternion with w >= 0: q or -q, normalised.
/// @pre q is finite and not zero.
[[nodiscard]] Quat canonical(const Quat& q);

/// Axis times angle of a unit quaternion: radians, of length 0 to pi.
[[nodiscard]] Vec3 rotationVector(const Quat& q);

/// The rotation by |v| radians about v; the inverse of rotationVector for |v| <= pi.
[[nodiscard]] Quat rotationFromVector(const Vec3& v);

} // namespace carina
