#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <optional>

namespace carina
{

/// How far the mouth of grown people opens at the incisors, on the average (32 to 77 mm), and with
/// the worst trismus that is drawn, which is of ours; 35 mm and less is called trismus (Dijkstra et
/// al., Int J Oral Maxillofac Surg 2006;35:337).
inline constexpr Length kMouthOpening = millimetres(50.0);
inline constexpr Length kLeastMouthOpening = millimetres(10.0);

/// How far the mouth opens at most while events last: from kMouthOpening evenly to
/// kLeastMouthOpening by the severity of trismus, in proportion to the patient; nothing without it,
/// and of who has no size.
/// @param size of the way from incisors to glottis, kReferenceWay being 1
[[nodiscard]] std::optional<Length> mostMouthOpening(const AirwayEvents& events, double size);

/// The pose of a jaw that goes no farther than that: where the incisors would be farther from where
/// they are with the mouth closed, the share of the way on which they are so far, with the same
/// share of the turn.
/// @param X_AJ pose of the mandible, the identity with the mouth closed
/// @pre most is above 0
[[nodiscard]] RigidTransform withinOpening(const RigidTransform& X_AJ, const Vec3& p_A_incisors,
                                           Length most);

} // namespace carina
