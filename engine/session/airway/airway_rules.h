#pragma once

#include "engine/core/result.h"
#include "engine/session/airway/airway_facts.h"

namespace carina
{

/// The longest time over which the events of an airway, and how the head lies, may change.
inline constexpr Duration kLongestAirwayChange = std::chrono::minutes{10};

/// Whether the values of a fact about the airway are possible for any patient.
/// @returns OutOfRange for a severity or time outside its range, and for events that are not in the
///          order of their kinds, each once; NotFinite.
[[nodiscard]] Result<void> checkAirway(const fact::AirwayEventsSet& fact);
/// Each angle by itself: two that do not go together are permitted, and drawn as withinReach has
/// them. So they are on the way from one position to another as well.
/// @returns OutOfRange for an angle or a time outside its range; NotFinite.
[[nodiscard]] Result<void> checkAirway(const fact::HeadPositionSet& fact);

} // namespace carina
