#pragma once

#include "engine/airway/tube/tube_in_lumen.h"
#include "engine/airway/tube/tube_shape_code.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/registration/calibration/tube_rest.h"
#include "engine/sync/streams/shape_view.h"

#include <span>
#include <vector>

namespace carina
{

/// What a tube that was touched is at rest: of its curve the two arcs that fit it.
[[nodiscard]] TubeRest restOf(const TubeShape& shape);
/// That of the tube whose form arrives.
[[nodiscard]] TubeRest restOf(const StreamShape& shape);

/// The centre line of such a tube in as many pieces as its rod, in the frame E of its connector.
[[nodiscard]] std::vector<Vec3> lineAtRest(const TubeRest& rest);

/// A form as it is sent with the poses of the tube.
/// @param p_E the nodes of its rod
[[nodiscard]] StreamShape toStream(const TubeRest& rest, std::span<const Vec3> p_E, SessionTime t);

/// The centre line that a form tells, at the nodes of the rod, in E.
[[nodiscard]] std::vector<Vec3> lineOf(const StreamShape& shape);
[[nodiscard]] std::vector<Vec3> lineOf(const ShapeBetween& shape);

} // namespace carina
