#pragma once

#include "engine/airway/lumen/moved_lumen.h"
#include "engine/airway/lumen/wall_surfaces.h"

#include <span>
#include <vector>

namespace carina
{

/// Points of the surfaces that a tube in the trunk can meet, of each cube of an edge the one that
/// is nearest to the trunk: 2 mm for teeth and lips, 3 mm for the larynx, 4 mm for pharynx and
/// tongue, of ours. There are none of the windpipe, which is even enough for sections.
/// @param trunk its sections as they were measured
/// @param first of them that has points, and the one behind the last
[[nodiscard]] std::vector<WallPoint> wallPoints(std::span<const AnatomyPart> parts,
                                                std::span<const LumenSection> trunk,
                                                std::size_t first, std::size_t last,
                                                const WallSurfaces& walls);

/// Divides the sections of a moved trunk and takes away of each what is nearer to a wall point than
/// the tube's radius: what stands into the lumen between two sections, and tissue that goes
/// elsewhere than the corners of a section. A side is moved inwards for each point, the one across
/// the direction that leads nearest to it. Then middles are made even again, within the sides.
/// @returns into how many pieces the way from a section to the next was divided: 1 without points
[[nodiscard]] std::size_t keepOff(MovedWay& trunk, const AirwayLumen& lumen,
                                  const TissueMotion& motion, const TissueMotion& push);

} // namespace carina
