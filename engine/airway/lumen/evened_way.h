#pragma once

#include "engine/airway/lumen/moved_lumen.h"

namespace carina
{

/// Makes the centre line of a way even: the middles between walls, which a few millimetres apart
/// lie beside each other by as much, are moved within their sections, towards the middle between
/// their neighbours and no farther than kMostOfReach of the way to a wall. Walls stay where they
/// are; what is seen from the new centre only behind another wall is left out. Lengths along the
/// way are those of the new line; the first and the last section stay.
void evenOut(MovedWay& way);

inline constexpr double kMostOfReach = 0.6; ///< of ours

} // namespace carina
