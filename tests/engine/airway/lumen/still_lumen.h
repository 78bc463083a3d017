#pragma once

#include "engine/airway/lumen/moved_lumen.h"

#include <algorithm>

namespace carina::test
{

/// A lumen with round sections along given centre lines.
/// @param lines of the ways, of at least two points; those that are empty are missing
/// @param radii of the lumen itself, as many as points
inline AirwayLumen roundLumen(const std::array<std::vector<Vec3>, kAirwayWays>& lines,
                              const std::array<std::vector<double>, kAirwayWays>& radii,
                              Length tubeRadius)
{
    AirwayLumen lumen;
    lumen.tubeRadius = tubeRadius;
    for (std::size_t w = 0; w < kAirwayWays; ++w) {
        const std::vector<Vec3>& line = lines[w];
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Vec3& before = line[i > 0 ? i - 1 : 0];
            const Vec3& after = line[std::min(i + 1, line.size() - 1)];
            const AcrossWay across = acrossWay(after - before);
            LumenSection section{.p_A_centre = line[i]};
            for (std::size_t k = 0; k < kLumenDirections; ++k)
                section.limits[k] = {line[i] + radii[w][i] * across.direction(k),
                                     -tubeRadius.si * across.direction(k)};
            lumen.ways[w].push_back(section);
        }
    }
    return lumen;
}

/// A lumen as the surfaces have it.
inline MovedLumen unmoved(const AirwayLumen& lumen)
{
    return moved(lumen, [](const Vec3& p_A, AirwayTissue /*tissue*/) { return p_A; });
}

} // namespace carina::test
