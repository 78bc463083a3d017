#include "apps/lab/attack/shown_objects.h"

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

constexpr double kSame = 1e-6; ///< metres, and of a quaternion and a scale

bool isSame(const std::optional<ActedPose>& a, const std::optional<ActedPose>& b)
{
    if (!a || !b)
        return a.has_value() == b.has_value();
    const double apart = (a->X_AO.translation() - b->X_AO.translation()).norm();
    const double turned =
        1.0 - std::abs(a->X_AO.rotation().coeffs().dot(b->X_AO.rotation().coeffs()));
    return apart <= kSame && turned <= kSame && std::abs(a->scale - b->scale) <= kSame;
}

} // namespace

ShownObjects::ShownObjects(const SessionNode& node)
{
    for (const auto state = node.state(); const auto& [id, object] : state->objects())
        m_before.emplace(id, shownBy(node, id));
}

std::int64_t ShownObjects::moved(const SessionNode& node) const
{
    return std::ranges::count_if(m_before, [&](const auto& before) {
        return !isSame(before.second, shownBy(node, before.first));
    });
}

std::optional<ActedPose> ShownObjects::shownBy(const SessionNode& node, ObjectId object)
{
    const auto now = node.now();
    const auto shown = now ? node.shown(object, *now) : std::nullopt;
    return shown ? std::optional{shown->acted} : std::nullopt;
}

} // namespace carina::lab
