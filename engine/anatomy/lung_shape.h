#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/implicit_shape.h"

namespace carina
{

/// One lung of the built-in patient, in A: a tapering body under the ribs with its apex above the
/// carina, hollowed from below by the dome of the diaphragm and from the middle by heart, great
/// vessels and spine, with the fissures between its lobes as grooves. The right lung is wider, sits
/// on the higher dome and has three lobes; the left has the cardiac notch.
///
/// @param size           1 for the adult; lengths go with it
/// @param outsideLungs   distance to what no lung may enter, in A
[[nodiscard]] ImplicitShape lungShape(Side side, double size, Implicit outsideLungs);

/// Where bronchus and vessels enter a lung of that size: it keeps its place when volumes are
/// matched.
[[nodiscard]] Vec3 hilum(Side side, double size);

} // namespace carina
