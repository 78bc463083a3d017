#pragma once

#include "engine/core/monotonic_clock.h"
#include "engine/net/node/session_node.h"

#include <set>

namespace carina::lab
{

/// Those who only take part, and whom no attack is to put out.
class HonestPeople
{
public:
    /// @param node by whose state it goes; outlives this
    HonestPeople(const SessionNode& node, std::vector<ParticipantId> people)
        : m_node{node}, m_people{std::move(people)}
    {
    }

    /// Notes who is not present; to be called often.
    void look()
    {
        const LocalTime now = monotonicNow();
        if (now < m_next)
            return;
        m_next = now + kLook;
        const auto state = m_node.state();
        for (const ParticipantId each : m_people) {
            const auto found = state->participants().find(each);
            if (found == state->participants().end() || !found->second.present)
                m_missed.insert(each);
        }
    }
    /// How many were missed since the last call.
    [[nodiscard]] std::int64_t takeMissed()
    {
        return static_cast<std::int64_t>(std::exchange(m_missed, {}).size());
    }

private:
    /// Nobody who was put out is back as fast.
    static constexpr Duration kLook = std::chrono::milliseconds{10};

    const SessionNode& m_node;
    std::vector<ParticipantId> m_people;
    std::set<ParticipantId> m_missed;
    LocalTime m_next{};
};

} // namespace carina::lab
