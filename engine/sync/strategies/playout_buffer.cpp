#include "engine/sync/strategies/playout_buffer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina
{

void PlayoutBuffer::add(SessionTime sent, const ActedPose& acted, LocalTime now)
{
    const Duration offset = now.time_since_epoch() - sent.time_since_epoch();
    if (!m_offsets.empty() && std::chrono::abs(offset - m_offsets.back()) > kAnotherClock)
        *this = {};
    m_offsets.push_back(offset);
    if (m_offsets.size() > kWindow)
        m_offsets.pop_front();
    follow(now);
    const auto place = std::ranges::upper_bound(m_snapshots, sent, {}, &Snapshot::sent);
    m_snapshots.insert(place, {sent, acted});
    if (m_snapshots.size() > kWindow)
        m_snapshots.pop_front();
}

void PlayoutBuffer::follow(LocalTime now)
{
    std::vector<Duration> sorted{m_offsets.begin(), m_offsets.end()};
    const auto index = static_cast<std::ptrdiff_t>((sorted.size() * 95 + 99) / 100 - 1);
    std::ranges::nth_element(sorted, sorted.begin() + index);
    const Duration wanted = sorted[static_cast<std::size_t>(index)] + kPeriod;
    const Duration step = (now - m_lastFollowed) / kFollowDivisor;
    m_playout =
        m_offsets.size() == 1 ? wanted : m_playout + std::clamp(wanted - m_playout, -step, step);
    m_lastFollowed = now;
}

ActedPose PlayoutBuffer::at(LocalTime t) const
{
    const SessionTime drawn{t.time_since_epoch() - playout()};
    const auto after = std::ranges::upper_bound(m_snapshots, drawn, {}, &Snapshot::sent);
    if (after == m_snapshots.begin())
        return m_snapshots.front().acted;
    const Snapshot& before = *std::prev(after);
    if (after == m_snapshots.end())
        return before.acted;
    const double share = toSeconds(drawn - before.sent) / toSeconds(after->sent - before.sent);
    return {interpolate(before.acted.X_AO, after->acted.X_AO, share),
            before.acted.scale * std::pow(after->acted.scale / before.acted.scale, share)};
}

} // namespace carina
