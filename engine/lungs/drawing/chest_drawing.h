#pragma once

#include "engine/lungs/drawing/chest_shape.h"
#include "engine/lungs/mechanics/lung_pair.h"

namespace carina
{

/// The pose in which the lungs are drawn for a state of the mechanics; a pure function of its
/// arguments.
///
/// - The surface of a lung encloses its volume at rest (FRC of this anatomy, and whatever else lies
///   inside the surface) plus the gas that the mechanics give above that of a healthy lung at rest:
///   drawn = restVolume + gas - healthy, exact to rounding. The volume cubic is solved for this
///   value.
/// - Diaphragm and ribs stand where their side of the chest has the room that the mechanics give,
///   the ribs making ribShare of its change, and all of it from where the diaphragm is as low as it
///   goes (kMostDescent). From there the lung collapses towards its hilum until it encloses the
///   drawn volume.
/// - The inside of a lung sinks by ChestShape::sag, less where the mediastinum is shifted into this
///   lung.
/// - The mediastinum is shifted as far as the mechanics give, at most by kDrawnShift. The part of
///   the range (rangeTaken) that a shift takes is not available to the lung it is shifted into.
///
/// Where all of this does not fit into the range in which the field keeps its orientation, the lung
/// leaves chest wall and diaphragm, towards rest, as far as its volume requires (a lung that does
/// nothing but collapse, farther: kMostCollapseAlone); then the
/// mediastinum moves back, as it does where it sinks into a lung that trapped gas has made so large
/// that it would come through the skin. A volume that is still out of reach is drawn as the nearest
/// possible one.
[[nodiscard]] ChestPose drawnPose(const LungPair& lungs, const ChestShape& shape,
                                  std::size_t level);

/// The volume that a lung is to enclose in drawnPose, before the range of the field limits it.
[[nodiscard]] Volume drawnVolume(const LungPair& lungs, const ChestShape& shape, Side side);

/// By how much less than drawnVolume the lungs enclose in the pose of drawnPose, both lungs
/// together; 0 where the range did not limit the pose.
[[nodiscard]] Volume notDrawn(const LungPair& lungs, const ChestShape& shape,
                              const ChestPose& drawn, std::size_t level);

/// The largest drawn shift, as a share of half the chest's width; 29 mm in the built-in adult.
inline constexpr double kDrawnShift = 0.25;

} // namespace carina
