#include "engine/sync/strategies/application_analysis.h"

#include <algorithm>

namespace carina
{
namespace
{

std::int64_t intervalOf(SessionTime t)
{
    return std::chrono::floor<ApplicationAnalysis::Interval>(t).time_since_epoch().count();
}

} // namespace

void ApplicationAnalysis::acted(ObjectId k, SessionTime at)
{
    const std::int64_t interval = intervalOf(at);
    const auto [found, isFirst] = m_counts.try_emplace(k);
    Counts& counts = found->second;
    counts.first = isFirst ? interval : std::min(counts.first, interval);
    ++counts.actions[interval];
    const std::int64_t newest = counts.actions.rbegin()->first;
    counts.actions.erase(counts.actions.begin(),
                         counts.actions.lower_bound(newest - 2 * kIntervals));
}

std::optional<double> ApplicationAnalysis::actionFrequency(ObjectId k, SessionTime now) const
{
    const auto found = m_counts.find(k);
    if (found == m_counts.end())
        return std::nullopt;
    const auto& [first, actions] = found->second;
    const std::int64_t current = intervalOf(now);
    const std::int64_t begin = std::max(first, current - kIntervals);
    if (begin >= current)
        return std::nullopt;
    std::uint64_t sum = 0;
    for (auto j = actions.lower_bound(begin); j != actions.end() && j->first < current; ++j)
        sum += j->second;
    return static_cast<double>(sum) / toSeconds(Interval{current - begin});
}

std::optional<double> upshotFrequency(Duration delay)
{
    if (delay <= Duration{})
        return std::nullopt;
    return 1.0 / toSeconds(delay);
}

} // namespace carina
