#include "engine/core/pauses.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{

void Pauses::add(SessionTime from, SessionTime until)
{
    CARINA_EXPECTS(from <= until && (m_pauses.empty() || m_pauses.back().until <= from));
    m_pauses.push_back({from, until});
}

bool Pauses::contains(SessionTime t) const
{
    return std::ranges::any_of(
        m_pauses, [t](const Pause& pause) { return pause.from <= t && t < pause.until; });
}

Duration Pauses::between(SessionTime from, SessionTime until) const
{
    if (until <= from)
        return {};
    Duration time = until - from;
    for (const Pause& pause : m_pauses) {
        const SessionTime begin = std::max(pause.from, from);
        const SessionTime end = std::min(pause.until, until);
        if (begin < end)
            time -= end - begin;
    }
    return time;
}

SessionTime Pauses::after(SessionTime from, Duration time) const
{
    CARINA_EXPECTS(time >= Duration{});
    for (const Pause& pause : m_pauses) {
        if (pause.until <= from)
            continue;
        const Duration before = std::max(pause.from - from, Duration{});
        if (time <= before)
            break;
        time -= before;
        from = pause.until;
        if (from == SessionTime::max())
            return from;
    }
    return from + time;
}

} // namespace carina
