#pragma once

#include "apps/lab/attack/attackers/attendee.h"
#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

/// One who comes in under a name of its own and then sends something in each turn, also when it is
/// out again.
class Participating : public Attack
{
public:
    Participating(const Target& target, Role role)
        : m_attendee{wayIn(target, role), target.attacker}
    {
    }

    void step() final
    {
        m_attendee.attends();
        if (m_attendee.intruder().isIn() && m_attendee.intruder().welcome())
            flood(m_attendee.intruder());
    }
    [[nodiscard]] std::int64_t sent() const final { return m_attendee.intruder().sent(); }

protected:
    virtual void flood(Intruder& intruder) = 0;

    [[nodiscard]] ProposalId anyId() { return ProposalId{m_attendee.random()()}; }
    [[nodiscard]] std::uint64_t anyNumber() { return m_attendee.random()(); }
    [[nodiscard]] Attendee& attendee() { return m_attendee; }
    [[nodiscard]] const Intruder& intruder() const { return m_attendee.intruder(); }

private:
    Attendee m_attendee;
};

} // namespace carina::lab
