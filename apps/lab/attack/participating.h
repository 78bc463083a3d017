#pragma once

#include "apps/lab/attack/attacks.h"
#include "engine/core/monotonic_clock.h"

#include <random>

namespace carina::lab
{

/// One who comes in under a name of its own and then sends something in each turn.
class Participating : public Attack
{
public:
    Participating(const Target& target, Role role)
        : m_name{target.attacker}, m_intruder{wayIn(target, role)}
    {
    }

    void step() final
    {
        if (!m_intruder.isIn())
            return;
        const LocalTime now = monotonicNow();
        if (m_intruder.ended() != m_endedBefore || (!m_intruder.welcome() && now >= m_nextHello)) {
            m_endedBefore = m_intruder.ended();
            m_nextHello = now + std::chrono::milliseconds{200};
            m_intruder.hello(m_name, ProposalId{m_random()}, ++m_connection);
        }
        if (m_intruder.welcome())
            flood(m_intruder);
    }
    [[nodiscard]] std::int64_t sent() const final { return m_intruder.sent(); }

protected:
    virtual void flood(Intruder& intruder) = 0;

    std::mt19937_64 m_random{kAttackSeed};

private:
    std::string m_name;
    Intruder m_intruder;
    int m_endedBefore = 0;
    std::uint32_t m_connection = 1;
    LocalTime m_nextHello{};
};

} // namespace carina::lab
