#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/geometry/deformation/neck_field.h"

namespace carina
{

/// How head and neck lie while events last: each angle as far from the neutral position as a stiff
/// neck lets it. Of the range that is drawn (withinReach), 1 less the severity is left on either
/// side, and at 1 nothing, as in a rigid collar: of ours.
[[nodiscard]] HeadPosition withinMotion(const HeadPosition& position, const AirwayEvents& events);

} // namespace carina
