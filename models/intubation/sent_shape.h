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
/// That of the tube whose form arrives. @pre it is not the patient's own
[[nodiscard]] TubeRest restOf(const StreamShape& shape);

/// What is sent of a tube at rest: of one that was touched its size and the two arcs, of the
/// patient's own that it is that one.
[[nodiscard]] StreamShape atRest(const TubeShape& tube);

/// In all that follows `own` is the patient's own tube (PatientModel::ownTube). Lines are in the
/// frame E of the connector, at the nodes of the rod.

/// The centre line at rest of the tube whose form arrives.
[[nodiscard]] std::vector<Vec3> lineAtRest(const StreamShape& shape, const TubeShape& own);

/// A form as it is sent with the poses of the tube.
/// @param of  of this tube at rest; its form is not read
/// @param p_E the line of its rod
[[nodiscard]] StreamShape toStream(StreamShape of, const TubeShape& own, std::span<const Vec3> p_E,
                                   SessionTime t);

/// The centre line that a form tells.
[[nodiscard]] std::vector<Vec3> lineOf(const StreamShape& shape, const TubeShape& own);
[[nodiscard]] std::vector<Vec3> lineOf(const ShapeBetween& shape, const TubeShape& own);

} // namespace carina
