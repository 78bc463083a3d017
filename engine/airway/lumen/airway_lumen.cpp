#include "engine/airway/lumen/airway_lumen.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{

Vec3 AcrossWay::direction(std::size_t k) const
{
    const double angle = 2.0 * std::numbers::pi * double(k) / double(kLumenDirections);
    return std::cos(angle) * side + std::sin(angle) * back;
}

AcrossWay acrossWay(const Vec3& along)
{
    const Vec3 t = along.normalized();
    const Vec3 left = Vec3::UnitX() - Vec3::UnitX().dot(t) * t;
    const Vec3 side = left.norm() > 1e-3 ? Vec3{left.normalized()} : t.unitOrthogonal();
    return {t, side, side.cross(t)};
}

AirwayLumen roundLumen(const std::array<std::vector<Vec3>, kAirwayWays>& lines,
                       const std::array<std::vector<double>, kAirwayWays>& radii, Length tubeRadius)
{
    CARINA_EXPECTS(lines.front().size() >= 2);
    AirwayLumen lumen;
    lumen.tubeRadius = tubeRadius;
    for (std::size_t w = 0; w < kAirwayWays; ++w) {
        const std::vector<Vec3>& line = lines[w];
        CARINA_EXPECTS(line.size() == radii[w].size());
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

} // namespace carina
