#include "engine/net/node/origins.h"

#include "engine/session/conduct_rules.h"
#include "engine/session/participant_limits.h"

#include <algorithm>

namespace carina
{

bool Origins::mayComeIn(const Comer& comer, const SessionState& state, SessionTime now) const
{
    const auto known = state.participants().find(comer.id);
    const bool isNew = known == state.participants().end();
    if (!isNew && hasPlace(known->second, now) && m_origins.contains(comer.id))
        return true;
    if (isNew && namesFrom(comer.from, comer.role) >= mostNamesFrom(comer.role))
        return false;
    return placesBeside(comer, state, now) < mostPresentFrom(comer.role);
}

void Origins::cameIn(const Comer& comer)
{
    m_origins.try_emplace(comer.id, Origin{comer.role, comer.from, {}}).first->second.last =
        comer.from;
}

void Origins::forgetOthersThan(const SessionState& state)
{
    std::erase_if(m_origins,
                  [&](const auto& entry) { return !state.participants().contains(entry.first); });
}

std::size_t Origins::namesFrom(const SourcePrefix& from, Role role) const
{
    return static_cast<std::size_t>(std::ranges::count_if(m_origins, [&](const auto& entry) {
        return entry.second.role == role && entry.second.first == from;
    }));
}

std::size_t Origins::placesBeside(const Comer& comer, const SessionState& state,
                                  SessionTime now) const
{
    return static_cast<std::size_t>(std::ranges::count_if(m_origins, [&](const auto& entry) {
        const auto& [id, origin] = entry;
        if (id == comer.id || origin.role != comer.role || origin.last != comer.from)
            return false;
        const auto known = state.participants().find(id);
        return known != state.participants().end() && hasPlace(known->second, now);
    }));
}

} // namespace carina
