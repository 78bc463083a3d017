#include "engine/sync/connection/peer_budget.h"

#include <algorithm>

namespace carina
{

bool TokenBucket::take(double amount, double perSecond, LocalTime now)
{
    if (!(perSecond > 0.0))
        return false;
    if (m_at && now > *m_at)
        m_used_s = std::max(0.0, m_used_s - toSeconds(now - *m_at));
    m_at = std::max(m_at.value_or(now), now);
    const double wanted_s = amount / perSecond;
    constexpr double kRounding_s = 1e-9;
    if (m_used_s + wanted_s > kBurst_s + kRounding_s)
        return false;
    m_used_s += wanted_s;
    return true;
}

bool PeerBudget::counted(TokenBucket& bucket, double amount, double perSecond, LocalTime now)
{
    if (bucket.take(amount, perSecond, now))
        return true;
    m_excess_s = std::max(0.0, m_excess_s - toSeconds(std::max(Duration{}, now - m_excessAt)));
    m_excess_s += amount / std::max(1.0, perSecond);
    m_excessAt = now;
    return false;
}

bool PeerBudget::takesDatagram(std::size_t bytes, LocalTime now)
{
    return counted(m_datagrams, 1.0, m_limits.datagrams, now)
           && counted(m_bytes, double(bytes), m_limits.bytes, now);
}

bool PeerBudget::takesProposal(LocalTime now)
{
    return counted(m_proposals, 1.0, m_limits.proposals, now);
}

bool PeerBudget::takesEvent(LocalTime now) { return counted(m_events, 1.0, m_limits.events, now); }

bool PeerBudget::takesSamples(std::size_t count, LocalTime now)
{
    return counted(m_samples, double(count), m_limits.samples, now);
}

} // namespace carina
