#include "engine/sync/connection/shared_budget.h"

#include <algorithm>

namespace carina
{

bool SharedBudget::takes(TokenBucket& share, TokenBucket& pot, double amount, double perSecond,
                         double saved, LocalTime now) const
{
    const auto members = static_cast<double>(std::max<std::size_t>(1, m_members));
    return share.take(amount, perSecond / members, now, saved) || pot.take(amount, perSecond, now);
}

bool SharedBudget::takesDatagram(Share& share, std::size_t bytes, LocalTime now)
{
    return takes(share.datagrams, m_datagrams, 1.0, m_limits.datagrams, 0.0, now)
           && takes(share.bytes, m_bytes, double(bytes), m_limits.bytes, 0.0, now);
}

bool SharedBudget::takesProposals(Share& share, double count, LocalTime now)
{
    return takes(share.proposals, m_proposals, count, m_limits.proposals, kSavedProposals, now);
}

} // namespace carina
