#pragma once

#include "engine/airway/lumen/moved_lumen.h"

namespace carina
{

/// Makes the centre line of a way even: the middles between walls, which a few millimetres apart
/// lie beside each other by as much, are moved within their sections, towards the middle between
/// their neighbours and no farther than kMostOfReach of the way to a wall. Walls stay where they
/// are; what is seen from the new centre only behind another wall is left out. Lengths along the
/// way are those of the new line; the first and the last section stay.
/// @param mostRoom metres, to each side: where a tube is too thick it has as much room more as is
///                 missing, and no more than that, as it need not lie in the middle
void evenOut(MovedWay& way, double mostRoom);

inline constexpr double kMostOfReach = 0.6; ///< of ours

} // namespace carina
