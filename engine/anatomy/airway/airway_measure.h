#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/units.h"
#include "engine/geometry/deformation/neck_field.h"

#include <optional>
#include <span>

namespace carina
{

/// The part of a patient's path_A from the teeth to the carina. Lives as long as the landmarks.
/// @pre the path has at least one point.
[[nodiscard]] std::span<const Vec3> pathFromTeeth(const AirwayLandmarks& airway);

/// Its length.
[[nodiscard]] Length teethToCarina(const AirwayLandmarks& airway);

/// The same landmarks and path as a neck has taken them.
[[nodiscard]] AirwayLandmarks bent(AirwayLandmarks airway, const NeckField& neck);

/// The length from teeth to carina of another airway, of which three places are known: along the
/// curve that airwayPath lays through them, as in the patient. Frame A, metres.
/// @returns nothing where two of the places are less than 2 cm apart.
[[nodiscard]] std::optional<Length> teethToCarina(const Vec3& p_A_incisors, const Vec3& p_A_glottis,
                                                  const Vec3& p_A_carina);

/// The shortest distance of a point from a line through these points.
/// @pre the line has at least one point.
[[nodiscard]] Length distanceFrom(std::span<const Vec3> line, const Vec3& p);

} // namespace carina
