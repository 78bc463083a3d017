#include "engine/anatomy/events/mouth_opening.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

std::optional<Length> mostMouthOpening(const AirwayEvents& events, double size)
{
    const auto trismus = std::ranges::find(events, AirwayEventKind::Trismus, &AirwayEvent::kind);
    if (trismus == events.end() || trismus->severity <= 0.0 || !(size > 0.0))
        return std::nullopt;
    return metres(size * std::lerp(kMouthOpening.si, kLeastMouthOpening.si, trismus->severity));
}

RigidTransform withinOpening(const RigidTransform& X_AJ, const Vec3& p_A_incisors, Length most)
{
    CARINA_EXPECTS(most.si > 0.0);
    const double opening = (X_AJ * p_A_incisors - p_A_incisors).norm();
    if (opening <= most.si)
        return X_AJ;
    const auto toIncisors = RigidTransform::translation(p_A_incisors);
    const RigidTransform aboutIncisors = toIncisors.inverse() * X_AJ * toIncisors;
    return toIncisors * interpolate({}, aboutIncisors, most.si / opening) * toIncisors.inverse();
}

} // namespace carina
