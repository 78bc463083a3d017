#include "engine/net/secure/endpoint_limiter.h"

namespace carina
{

bool EndpointLimiter::hasRoom(const Endpoint& from, LocalTime now) const
{
    const auto known = m_fullAgain.find(from);
    return known == m_fullAgain.end() || kRate.withOneMore(known->second, now);
}

void EndpointLimiter::count(const Endpoint& from, LocalTime now)
{
    if (now >= m_nextForget) {
        std::erase_if(m_fullAgain, [now](const auto& entry) { return entry.second <= now; });
        m_nextForget = now + kRate.interval;
    }
    LocalTime& fullAgain = m_fullAgain.try_emplace(from, now).first->second;
    fullAgain = kRate.withOneMore(fullAgain, now).value_or(fullAgain);
}

} // namespace carina
