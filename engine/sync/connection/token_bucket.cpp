#include "engine/sync/connection/token_bucket.h"

#include <algorithm>

namespace carina
{

bool TokenBucket::takeOf(double capacity, double amount, double perSecond, LocalTime now)
{
    if (!(perSecond > 0.0))
        return false;
    if (m_at && now > *m_at)
        m_used_s = std::max(0.0, m_used_s - toSeconds(now - *m_at));
    m_at = std::max(m_at.value_or(now), now);
    const double wanted_s = amount / perSecond;
    constexpr double kRounding_s = 1e-9;
    if (m_used_s + wanted_s > capacity / perSecond + kRounding_s)
        return false;
    m_used_s += wanted_s;
    return true;
}

void TokenBucket::putBack(double amount, double perSecond)
{
    if (perSecond > 0.0)
        m_used_s = std::max(0.0, m_used_s - amount / perSecond);
}

} // namespace carina
