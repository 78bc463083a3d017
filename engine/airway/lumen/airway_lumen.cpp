#include "engine/airway/lumen/airway_lumen.h"

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

} // namespace carina
