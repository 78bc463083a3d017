#include "engine/sync/connection/peer_budget.h"

#include <algorithm>

namespace carina
{

bool PeerBudget::counted(TokenBucket& bucket, double amount, double perSecond, LocalTime now)
{
    if (bucket.take(amount, perSecond, now))
        return true;
    m_excess_s = std::max(0.0, m_excess_s - toSeconds(std::max(Duration{}, now - m_excessAt)));
    m_excess_s += amount / std::max(1.0, perSecond);
    m_excessAt = now;
    return false;
}

void PeerBudget::comes(std::shared_ptr<SharedBudget> others, LocalTime now)
{
    goes(now);
    m_shared = std::move(others);
    if (m_shared)
        m_share.comes(m_shared->fair(now));
}

void PeerBudget::goes(LocalTime now)
{
    if (m_shared)
        m_share.goes(m_shared->fair(now));
}

bool PeerBudget::takesDatagram(std::size_t bytes, LocalTime now)
{
    return counted(m_datagrams, 1.0, m_limits.datagrams, now)
           && counted(m_bytes, double(bytes), m_limits.bytes, now)
           && (!m_shared || m_shared->takesDatagram(m_share, bytes, now));
}

PeerBudget::Verdict PeerBudget::takesFacts(TokenBucket& bucket, double amount, double perSecond,
                                           double facts, LocalTime now)
{
    if (!counted(bucket, amount, perSecond, now))
        return Verdict::Refused;
    if (!m_shared || m_shared->takesProposals(m_share, facts, now))
        return Verdict::Taken;
    bucket.putBack(amount, perSecond);
    return Verdict::Later;
}

bool PeerBudget::takesEvent(LocalTime now)
{
    return counted(m_events, 1.0, m_limits.events, now)
           && (!m_shared || m_shared->takesEvent(m_share, now));
}

bool PeerBudget::takesSamples(std::size_t count, LocalTime now)
{
    return counted(m_samples, double(count), m_limits.samples, now);
}

} // namespace carina
