#include "apps/lab/attack/attackers/attendee.h"

#include <utility>

namespace carina::lab
{
namespace
{

constexpr Duration kHelloAgain = std::chrono::milliseconds{200};

} // namespace

std::mt19937_64 randomOf(const std::string& name)
{
    std::seed_seq seed(name.begin(), name.end());
    return std::mt19937_64{seed};
}

Attendee::Attendee(const WayIn& way, std::string name)
    : m_name{std::move(name)}, m_random{randomOf(m_name)}, m_intruder{way}
{
}

bool Attendee::attends()
{
    if (!m_intruder.isIn())
        return false;
    const LocalTime now = monotonicNow();
    if (!m_intruder.takesPart() && now >= m_nextHello) {
        m_nextHello = now + kHelloAgain;
        if (std::exchange(m_isNewRun, false))
            m_join = ProposalId{m_random()};
        m_intruder.hello(m_name, m_join, ++m_connection, Intruder::Has::WhatItHeard);
    }
    if (!m_intruder.takesPart())
        return false;
    m_isNewRun = true; // where it comes in again
    m_intruder.acknowledge();
    return true;
}

void Attendee::helloWithNothing()
{
    m_intruder.hello(m_name, m_join, ++m_connection, Intruder::Has::Nothing);
}

void Attendee::leave()
{
    if (m_intruder.takesPart())
        m_intruder.leave();
    m_nextHello = {};
}

} // namespace carina::lab
