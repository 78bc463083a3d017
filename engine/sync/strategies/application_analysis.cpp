#include "engine/sync/strategies/application_analysis.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{
namespace
{

std::int64_t secondOf(SessionTime t)
{
    return std::chrono::floor<std::chrono::seconds>(t).time_since_epoch().count();
}

} // namespace

void ApplicationAnalysis::acted(ParticipantId k, ObjectId j, SessionTime at)
{
    count(k, j, secondOf(at), 1);
}

void ApplicationAnalysis::count(ParticipantId k, ObjectId j, std::int64_t second,
                                std::uint32_t actions)
{
    const auto [found, isFirst] = m_counts.try_emplace(k);
    Counts& counts = found->second;
    counts.first = isFirst ? second : std::min(counts.first, second);
    counts.seconds[second][j] += actions;
    const std::int64_t newest = counts.seconds.rbegin()->first;
    counts.seconds.erase(counts.seconds.begin(), counts.seconds.lower_bound(newest - 2 * kSeconds));
}

void ApplicationAnalysis::add(const ApplicationAnalysis& other)
{
    for (const auto& [k, counts] : other.m_counts) {
        for (const auto& [second, actions] : counts.seconds)
            for (const auto& [j, number] : actions)
                count(k, j, second, number);
        Counts& sum = m_counts[k];
        sum.first = std::min(sum.first, counts.first);
    }
}

void ApplicationAnalysis::forget(ObjectId j)
{
    for (auto& [k, counts] : m_counts) {
        for (auto& [second, actions] : counts.seconds)
            actions.erase(j);
        std::erase_if(counts.seconds, [](const auto& second) { return second.second.empty(); });
    }
    std::erase_if(m_counts, [](const auto& counts) { return counts.second.seconds.empty(); });
}

std::vector<ParticipantId> ApplicationAnalysis::participants() const
{
    std::vector<ParticipantId> all;
    for (const auto& [k, counts] : m_counts)
        all.push_back(k);
    return all;
}

std::optional<double> ApplicationAnalysis::actionFrequency(ParticipantId k, std::size_t m,
                                                           SessionTime now) const
{
    CARINA_EXPECTS(m >= 1);
    const auto found = m_counts.find(k);
    if (found == m_counts.end())
        return std::nullopt;
    const auto& [first, seconds] = found->second;
    const std::int64_t current = secondOf(now);
    const std::int64_t begin = std::max(first, current - kSeconds);
    if (begin >= current)
        return std::nullopt;
    std::uint64_t sum = 0;
    for (auto second = seconds.lower_bound(begin);
         second != seconds.end() && second->first < current; ++second)
        for (const auto& [j, actions] : second->second)
            sum += actions;
    return static_cast<double>(sum)
           / (static_cast<double>(m) * static_cast<double>(current - begin));
}

std::optional<double> upshotFrequency(Duration delay)
{
    if (delay <= Duration{})
        return std::nullopt;
    return 1.0 / toSeconds(delay);
}

} // namespace carina
