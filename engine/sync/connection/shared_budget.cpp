#include "engine/sync/connection/shared_budget.h"

#include <algorithm>

namespace carina
{

void SharedBudget::setMembers(std::size_t members, LocalTime now)
{
    static_cast<void>(fair(now));
    m_members = std::max<std::size_t>(1, members);
}

LocalTime SharedBudget::fair(LocalTime now)
{
    if (m_fairAt && now > *m_fairAt)
        m_fair += (now - *m_fairAt) / static_cast<Duration::rep>(m_members);
    m_fairAt = std::max(m_fairAt.value_or(now), now);
    return m_fair;
}

bool SharedBudget::takes(TokenBucket& share, double capacity, LocalTime present, TokenBucket& pot,
                         double amount, double perSecond, LocalTime now) const
{
    return share.takeOf(capacity, amount, perSecond, present) || pot.take(amount, perSecond, now);
}

bool SharedBudget::takesDatagram(Share& share, std::size_t bytes, LocalTime now)
{
    const LocalTime present = share.present(fair(now));
    const double burst_s = TokenBucket::kBurst_s / static_cast<double>(m_members);
    return takes(share.m_datagrams, burst_s * m_limits.datagrams, present, m_datagrams, 1.0,
                 m_limits.datagrams, now)
           && takes(share.m_bytes, burst_s * m_limits.bytes, present, m_bytes, double(bytes),
                    m_limits.bytes, now);
}

bool SharedBudget::takesEvent(Share& share, LocalTime now)
{
    const LocalTime present = share.present(fair(now));
    const double capacity =
        TokenBucket::kBurst_s * m_limits.events / static_cast<double>(m_members);
    return takes(share.m_events, capacity, present, m_events, 1.0, m_limits.events, now);
}

bool SharedBudget::takesProposals(Share& share, double count, LocalTime now)
{
    return takes(share.m_proposals, kSavedProposals, share.present(fair(now)), m_proposals, count,
                 m_limits.proposals, now);
}

} // namespace carina
