#include "engine/net/discovery/found_sessions.h"

#include <algorithm>

namespace carina
{
bool FoundSessions::heard(const FoundSession& found, LocalTime now)
{
    const auto known = m_sessions.find(found.notice.session);
    if (known == m_sessions.end()) {
        if (m_sessions.size() >= kMost)
            return false;
        m_sessions.emplace(found.notice.session, Heard{found, now});
        return true;
    }
    Heard& before = known->second;
    if (before.found.address == found.address || found.isOnThisComputer()) {
        before.last = now;
        return std::exchange(before.found, found) != found;
    }
    return false;
}

bool FoundSessions::forget(LocalTime now)
{
    return std::erase_if(
               m_sessions,
               [now](const auto& entry) { return now >= entry.second.last + kForgottenAfter; })
           > 0;
}

std::vector<FoundSession> FoundSessions::list() const
{
    std::vector<FoundSession> sessions;
    for (const auto& [key, heard] : m_sessions)
        sessions.push_back(heard.found);
    std::ranges::stable_sort(sessions, {}, [](const FoundSession& found) -> const std::string& {
        return found.notice.name;
    });
    return sessions;
}

} // namespace carina
