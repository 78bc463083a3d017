#pragma once

#include "engine/airway/lumen/airway_lumen.h"
#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"

#include <span>

namespace carina
{

/// The lumen for tubes of a radius in a patient, measured in its surfaces.
///
/// - The trunk follows path_A from 30 mm in front of the upper incisors to the carina. Each of its
///   centres is first taken away from the walls that are nearer than the tube's radius, then to the
///   middle between those to the left and right, and in front and behind.
/// - From there a ball as thick as the tube is moved in kLumenDirections until it touches a surface
///   of mouth, pharynx, larynx or trachea: so the tube lies outside of every triangle, whatever
///   encloses it. Where it does not fit, a smaller one is taken, and the difference taken off.
/// - Beyond usual sizes (kMouth and the others), in proportion to the way from the teeth to the
///   carina, it is not moved: where sets lack mucosa, and where space goes on into the nose,
///   between the cheeks or beside the larynx.
/// - Main bronchi: from the carina along the middles of the surfaces of this role, without them at
///   the usual angles; of usual width, as surfaces of bronchi are often closed at their ends.
/// - Oesophagus: along the middle of its surface, or 8 mm behind the trachea's wall. At rest it is
///   shut, but it yields to a tube; so it has a usual width instead of a measured one.
/// - In front of the teeth a funnel with a round edge, of ours.
///
/// What yields, in proportion too: tongue and pharynx above the larynx by kGiveOfThroat, the cords
/// by kGiveOfCords, all else by kGiveOfWall, to each side. The first two are of ours: an open
/// glottis is 6 to 9 mm wide (Miller, 6th edition), a tube of 8.0 mm 10.9 mm.
///
/// @returns NoAirway where the path is shorter than 5 cm; OutOfRange for a radius outside 1 to 10
/// mm
[[nodiscard]] Result<AirwayLumen> measuredLumen(std::span<const AnatomyPart> parts,
                                                const AirwayLandmarks& landmarks,
                                                Length tubeRadius);

/// Whether a part is read for that: others may be left out.
[[nodiscard]] bool tellsLumen(PartRole role);

/// From the teeth to the carina in the reference man, to which all that follows belongs.
inline constexpr Length kReferenceDepth = millimetres(260.0);

/// How far the wall is from the middle of a way at most; of ours, from the usual sizes of adults.
inline constexpr Length kMouth = millimetres(22.0);
inline constexpr Length kPharynx = millimetres(16.0);
inline constexpr Length kLarynx = millimetres(12.0);    ///< trachea and main bronchi, too
inline constexpr Length kOesophagus = millimetres(9.0); ///< how far a tube dilates it

inline constexpr Length kGiveOfThroat = millimetres(6.0);
inline constexpr Length kGiveOfCords = millimetres(2.5);
inline constexpr Length kGiveOfWall = millimetres(0.25);

} // namespace carina
