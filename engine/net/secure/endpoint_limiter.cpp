#include "engine/net/secure/endpoint_limiter.h"

#include <algorithm>

namespace carina
{

bool EndpointLimiter::hasRoom(const Endpoint& from, LocalTime now) const
{
    const auto known = m_fullAgain.find(from);
    return known == m_fullAgain.end()
           || std::max(known->second, now) + kInterval <= now + kBurst * kInterval;
}

void EndpointLimiter::count(const Endpoint& from, LocalTime now)
{
    if (now >= m_nextForget) {
        std::erase_if(m_fullAgain, [now](const auto& entry) { return entry.second <= now; });
        m_nextForget = now + kInterval;
    }
    LocalTime& fullAgain = m_fullAgain.try_emplace(from, now).first->second;
    fullAgain = std::max(fullAgain, now) + kInterval;
}

} // namespace carina
