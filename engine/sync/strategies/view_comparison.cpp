#include "engine/sync/strategies/view_comparison.h"

#include <algorithm>

namespace carina
{

SessionTime ViewComparison::timeBefore(SessionTime t)
{
    return std::chrono::floor<std::chrono::duration<Duration::rep, std::ratio<1, 4>>>(t);
}

void ViewComparison::remember(const ShownPose& shown)
{
    std::deque<ShownPose>& kept = m_shown[shown.object];
    kept.push_back(shown);
    if (kept.size() > kKept)
        kept.pop_front();
}

std::optional<Drift> ViewComparison::compare(const ShownPose& owners) const
{
    const auto kept = m_shown.find(owners.object);
    if (kept == m_shown.end())
        return std::nullopt;
    const auto shown = std::ranges::find(kept->second, owners.at, &ShownPose::at);
    if (shown == kept->second.end())
        return std::nullopt;
    return driftBetween(ActedPose{owners.X_AO, owners.scale}, {shown->X_AO, shown->scale});
}

} // namespace carina
