#pragma once

#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"

#include <span>

namespace carina
{

/// Distance in front of the incisors at which a path begins: space for a tube outside the mouth.
inline constexpr Length kPathInFrontOfTeeth = millimetres(100.0);

/// The path of a tube: straight from in front of the incisors to their edge, over the tongue in one
/// smooth curve, through the glottis and along `down`. Points are at most 2 mm apart; incisors and
/// glottis are among them. Any origin, with the axes of A; metres.
///
/// @param down centreline from the glottis to the carina
/// @pre `down` has at least two points, and the first two differ.
[[nodiscard]] Centreline airwayPath(const Vec3& p_A_incisors, std::span<const Vec3> down);

/// How steeply a straight line rises from the glottis to the incisors: in a ratio of 3 : 2, as in
/// the man of BodyParts3D.
inline constexpr Angle kRiseToIncisors{0.5880026035475675};

/// The position of the incisors for which the curve of airwayPath from them to the glottis has this
/// length. They lie in front of and above the glottis, with this rise.
[[nodiscard]] Vec3 incisorsAtLength(std::span<const Vec3> down, Length incisorsToGlottis,
                                    Angle rise = kRiseToIncisors);

/// Finds the landmarks of an anatomy set from its surfaces, in their frame: any origin, with the
/// axes of A.
///
/// - Carina: the lowest place at which the medial walls of both main bronchi are nearest to each
///   other; without bronchi the lower end of the trachea.
/// - Centreline of the trachea: the mean of each of its sections across z, smoothed.
/// - Glottis: the middle of the parts whose name contains "vocal ligament"; without them on the
///   extended centreline, above the trachea's upper end by 26/101 of its length (cords to carina
///   12.7 cm, trachea 10.1 cm).
/// - Incisors: the middle of the lower edges of the parts of role Tooth whose name contains "upper
///   central" and "incisor"; without them 1 cm above and 1 cm in front of the anterior upper rim of
///   the mandible; without a mandible by incisorsAtLength, with 13.5/10.1 of the trachea's length.
///
/// @returns NoAirway without a trachea at least 2 cm high.
[[nodiscard]] Result<AirwayLandmarks> findAirway(std::span<const AnatomyPart> parts);

} // namespace carina
