#include "engine/net/entry/source_limiter.h"

#include <algorithm>

namespace carina
{

bool SourceLimiter::admits(const SourcePrefix& source, LocalTime now)
{
    if (m_fullAgain.size() >= kMostSources && !m_fullAgain.contains(source))
        forgetQuietSources(now);
    const bool isOther = m_fullAgain.size() >= kMostSources && !m_fullAgain.contains(source);
    LocalTime& fullAgain =
        isOther ? m_othersFullAgain : m_fullAgain.try_emplace(source, now).first->second;
    const LocalTime next = std::max(fullAgain, now) + kInterval;
    if (next > now + kBurst * kInterval)
        return false;
    fullAgain = next;
    return true;
}

void SourceLimiter::forgetQuietSources(LocalTime now)
{
    std::erase_if(m_fullAgain, [now](const auto& entry) { return entry.second <= now; });
}

} // namespace carina
