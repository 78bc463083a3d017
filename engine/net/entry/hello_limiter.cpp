#include "engine/net/entry/hello_limiter.h"

#include <algorithm>

namespace carina
{
namespace
{

/// How often sources are forgotten: all of them are looked at, up to some 2300.
constexpr Duration kForgetInterval = std::chrono::milliseconds{100};
/// Of what all have together, who sends without end is left this part.
constexpr int kPartOfTurns = 2;
/// Turns that sources may have at one moment, small beside the half that is kept for who is new.
constexpr int kTurnsAtOnce = 16;

} // namespace

bool HelloLimiter::admits(const SourcePrefix& source, LocalTime now)
{
    forgetQuietSources(now);
    const auto known = m_sources.find(source);
    const bool isNew = known == m_sources.end();
    const LocalTime next = (isNew ? now : std::max(known->second.fullAgain, now)) + kInterval;
    const LocalTime nextOfAll = std::max(m_allFullAgain, now) + kIntervalOfAll;
    if (next > now + kBurst * kInterval || nextOfAll > now + kBurstOfAll * kIntervalOfAll)
        return false;
    const bool isScarce = nextOfAll > now + kBurstOfAll / kPartOfTurns * kIntervalOfAll;
    if (isScarce && !isNew && !hasTurn(known->second, now))
        return false;
    m_sources.insert_or_assign(source, Source{next, now});
    m_allFullAgain = nextOfAll;
    return true;
}

bool HelloLimiter::hasTurn(const Source& source, LocalTime now)
{
    constexpr Duration kTurn = kPartOfTurns * kIntervalOfAll;
    const LocalTime next = std::max(m_turnsFullAgain, now) + kTurn;
    const auto others = static_cast<Duration::rep>(m_sources.size());
    if (now < source.last + others * kTurn || next > now + kTurnsAtOnce * kTurn)
        return false;
    m_turnsFullAgain = next;
    return true;
}

void HelloLimiter::forgetQuietSources(LocalTime now)
{
    if (now < m_nextForget)
        return;
    m_nextForget = now + kForgetInterval;
    std::erase_if(m_sources, [now](const auto& entry) {
        return entry.second.fullAgain <= now && entry.second.last + kRemembered <= now;
    });
}

} // namespace carina
