#pragma once

#include "engine/net/node/session_node.h"

#include <map>
#include <utility>

namespace carina::lab
{

/// The patient of each station at a time. An attacker may leave others, which hold more memory.
class LaidPatients
{
public:
    explicit LaidPatients(const SessionNode& node) : m_laid{laidAt(*node.state())} {}

    /// Whether they are laid now.
    [[nodiscard]] bool areLaid(const SessionNode& node) const
    {
        return laidAt(*node.state()) == m_laid;
    }
    /// Proposes them anew where others are laid.
    void layAgain(SessionNode& instructor) const
    {
        const auto now = laidAt(*instructor.state());
        for (const auto& [station, patient] : m_laid)
            if (const auto found = now.find(station);
                found != now.end() && found->second != patient)
                instructor.propose(station, fact::AnatomyChosen{patient.first, patient.second});
    }

private:
    using Laid = std::map<StationId, std::pair<std::string, std::string>>;

    static Laid laidAt(const SessionState& state)
    {
        Laid laid;
        for (const auto& [id, station] : state.stations())
            if (state.isOpen(id))
                laid[id] = {station.anatomyHash, station.anatomyName};
        return laid;
    }

    Laid m_laid;
};

} // namespace carina::lab
