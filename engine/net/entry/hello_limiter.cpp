#include "engine/net/entry/hello_limiter.h"

namespace carina
{
namespace
{

/// How often sources are forgotten: all of them are looked at, up to some 2300.
constexpr Duration kForgetInterval = std::chrono::milliseconds{100};
/// Of what all have together, who sends without end is left this part.
constexpr int kPartOfTurns = 2;
constexpr BurstRate kPlentyOfAll{HelloLimiter::kRateOfAll.burst / kPartOfTurns,
                                 HelloLimiter::kRateOfAll.interval};
/// The turns of all: few at one moment beside the half that is kept for who is new.
constexpr BurstRate kTurns{.burst = 16,
                           .interval = HelloLimiter::kRateOfAll.interval * kPartOfTurns};

} // namespace

bool HelloLimiter::admits(const SourcePrefix& source, LocalTime now)
{
    forgetQuietSources(now);
    const auto known = m_sources.find(source);
    const bool isNew = known == m_sources.end();
    const auto next = kRate.withOneMore(isNew ? now : known->second.fullAgain, now);
    const auto nextOfAll = kRateOfAll.withOneMore(m_allFullAgain, now);
    if (!next || !nextOfAll)
        return false;
    const bool isScarce = !kPlentyOfAll.withOneMore(m_allFullAgain, now);
    if (isScarce && !isNew && !hasTurn(known->second, now))
        return false;
    m_sources.insert_or_assign(source, Source{*next, now});
    m_allFullAgain = *nextOfAll;
    return true;
}

bool HelloLimiter::hasTurn(const Source& source, LocalTime now)
{
    const auto others = static_cast<Duration::rep>(m_sources.size());
    const auto next = kTurns.withOneMore(m_turnsFullAgain, now);
    if (now < source.last + others * kTurns.interval || !next)
        return false;
    m_turnsFullAgain = *next;
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
