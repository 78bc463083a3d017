#pragma once

#include "engine/airway/form/tube_form.h"
#include "engine/sync/streams/shape_view.h"

#include <vector>

namespace carina
{

/// A form as it is sent with the poses of the tube, and as it arrives.
[[nodiscard]] StreamShape toStream(const TubeForm& form, SessionTime t);
[[nodiscard]] TubeForm fromStream(const StreamShape& shape);

/// The centre line of a tube of another, in the frame of its connector: points at equal distances
/// along it but for what goes on beyond the newest form.
[[nodiscard]] std::vector<Vec3> lineOf(const ShapeBetween& shape);

} // namespace carina
