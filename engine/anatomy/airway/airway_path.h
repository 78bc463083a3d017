#pragma once

#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"

#include <span>

namespace carina
{

/// How far in front of the incisors a path begins: room for the part of a tube outside the mouth.
inline constexpr Length kPathInFrontOfTeeth = millimetres(100.0);

/// The way of a tube: straight from in front of the incisors to their edge, over the tongue in one
/// curve without a kink, through the glottis and along `down`. In the frame of the arguments, whose
/// axes are those of A; points 2 mm apart, the glottis and the incisors on the line.
///
/// @param down from the glottis to the carina
/// @pre `down` has at least two points and starts with a proper step.
[[nodiscard]] Centreline airwayPath(const Vec3& p_A_incisors, std::span<const Vec3> down);

/// Where the incisors lie when the curve of airwayPath from them to the glottis has this length: in
/// front of the glottis, three parts forward to two parts up, as in the man whose surfaces are
/// published (BodyParts3D).
[[nodiscard]] Vec3 incisorsAtLength(std::span<const Vec3> down, Length incisorsToGlottis);

/// Finds the landmarks of an anatomy set from its surfaces. Their frame has the axes of A and any
/// origin, and so have the results.
///
/// - Carina: the lowest place at which the inner walls of both main bronchi are nearest to each
///   other; without them the lower end of the trachea.
/// - Trachea's centreline: the mean of each section of the trachea across z, smoothed.
/// - Glottis: the middle of the parts whose name holds "vocal ligament"; without them on the
///   trachea's line produced, above its upper end by 26 parts in 101 of its length (cords to carina
///   12.7 cm, trachea 10.1 cm).
/// - Incisors: the middle of the lower edges of the parts of role Tooth whose name holds "upper
///   central" and "incisor"; without them 1 cm above and 1 cm in front of the front upper rim of
///   the mandible; without that by incisorsAtLength, 13.5 parts in 10.1 of the trachea's length.
///
/// @returns NoAirway without a trachea at least 2 cm high.
[[nodiscard]] Result<AirwayLandmarks> findAirway(std::span<const AnatomyPart> parts);

} // namespace carina
