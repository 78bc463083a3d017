#include "engine/geometry/rotation.h"

#include "engine/core/expects.h"

#include <cmath>

namespace carina
{

Angle angleOf(const Quat& q) { return radians(2.0 * std::atan2(q.vec().norm(), std::abs(q.w()))); }

Angle angleBetween(const Quat& q_s, const Quat& q_c) { return angleOf(q_s * q_c.conjugate()); }

Quat canonical(const Quat& q)
{
    const double norm = q.norm();
    CARINA_EXPECTS(std::isfinite(norm) && norm > 0.0);
    Quat unit{q.coeffs() / (q.w() < 0.0 ? -norm : norm)};
    return unit;
}

Vec3 rotationVector(const Quat& q)
{
    const Quat unit = canonical(q);
    const double sine = unit.vec().norm();
    // angle / sin(angle/2) tends to 2 at the identity, where the axis is undefined.
    const double scale = sine > 0.0 ? 2.0 * std::atan2(sine, unit.w()) / sine : 2.0;
    return scale * unit.vec();
}

Quat rotationFromVector(const Vec3& v)
{
    const double angle = v.norm();
    // sin(angle/2) / angle by its series where the quotient would be 0/0.
    const double scale = angle > 1e-8 ? std::sin(0.5 * angle) / angle : 0.5;
    const Vec3 vec = scale * v;
    return Quat{std::cos(0.5 * angle), vec.x(), vec.y(), vec.z()};
}

} // namespace carina
