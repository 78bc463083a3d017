#include "engine/net/entry/source_limiter.h"

namespace carina
{

bool SourceLimiter::admits(const SourcePrefix& source, LocalTime now)
{
    if (m_fullAgain.size() >= kMostSources && !m_fullAgain.contains(source))
        forgetQuietSources(now);
    const bool isOther = m_fullAgain.size() >= kMostSources && !m_fullAgain.contains(source);
    LocalTime& fullAgain =
        isOther ? m_othersFullAgain : m_fullAgain.try_emplace(source, now).first->second;
    const auto next = m_rate.withOneMore(fullAgain, now);
    fullAgain = next.value_or(fullAgain);
    return next.has_value();
}

void SourceLimiter::forgetQuietSources(LocalTime now)
{
    std::erase_if(m_fullAgain, [now](const auto& entry) { return entry.second <= now; });
}

} // namespace carina
