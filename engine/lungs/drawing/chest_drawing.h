#pragma once

#include "engine/lungs/drawing/chest_shape.h"
#include "engine/lungs/mechanics/lung_pair.h"

namespace carina
{

/// The pose in which these lungs show what the mechanics say, a pure function of its arguments.
///
/// - The surface of a lung encloses what it encloses at rest (FRC of this anatomy, and whatever
///   else lies within it) and the gas that the mechanics have more than at rest in health:
///   drawn = restVolume + gas - healthy, to the last digits. This is what the cubic is solved for.
/// - Diaphragm and ribs stand where their side of the chest has the room that the mechanics say,
///   each with the share of it that the mechanics give them; the lung falls in from there towards
///   its hilum by the gas beside it.
/// - The inside of a lung has sunk by the sag of the mechanics, less where the mediastinum leans on
///   it.
/// - The mediastinum goes aside as far as the mechanics say, at most by kDrawnShift of half the
///   chest's width: what it takes of the range, the lung that it leans on has no more for itself.
///
/// Where all of this does not fit into the range in which the field keeps its orientation, chest
/// wall and diaphragm go back towards rest as far as the lung's volume needs, then the mediastinum,
/// and a volume beyond even that is drawn as the nearest there is.
[[nodiscard]] ChestPose drawnPose(const LungPair& lungs, const ChestShape& shape,
                                  std::size_t level);

/// The volume that drawnPose encloses in a lung, for all that the range holds.
[[nodiscard]] Volume drawnVolume(const LungPair& lungs, const ChestShape& shape, Side side);

/// By how much less than drawnVolume both lungs together enclose in the pose of drawnPose: 0 where
/// the range holds what the mechanics say.
[[nodiscard]] Volume notDrawn(const LungPair& lungs, const ChestShape& shape,
                              const ChestPose& drawn, std::size_t level);

inline constexpr double kDrawnShift = 0.15; ///< 16 mm in the built-in adult

} // namespace carina
