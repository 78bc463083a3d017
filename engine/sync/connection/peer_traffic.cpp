#include "engine/sync/connection/peer_traffic.h"

#include <algorithm>
#include <cmath>

namespace carina
{

void RateMeter::add(double amount, LocalTime now)
{
    m_perSecond = perSecond(now) + amount / kTimeConstant_s;
    m_at = std::max(m_at, now);
}

double RateMeter::perSecond(LocalTime now) const
{
    const double age_s = toSeconds(std::max(Duration{}, now - m_at));
    return m_perSecond * std::exp(-age_s / kTimeConstant_s);
}

} // namespace carina
