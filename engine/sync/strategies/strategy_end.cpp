#include "engine/sync/strategies/strategy_end.h"

#include <algorithm>
#include <iterator>

namespace carina
{
namespace
{

bool isRelayed(const StrategyChoice& choice)
{
    return choice.kind != StrategyKind::SessionClock && choice.kind != StrategyKind::LocalLag;
}

std::vector<ParticipantId> without(std::vector<ParticipantId> all, ParticipantId one)
{
    std::erase(all, one);
    return all;
}

} // namespace

void StrategyEnd::choose(const StrategyChoice& choice, const StarSeat& seat, LocalTime now)
{
    m_participant =
        isRelayed(choice) ? syncStrategy(choice.kind).makeParticipant(seat, choice, now) : nullptr;
}

void StrategyEnd::setOthers(std::span<const ParticipantId> others, LocalTime now)
{
    if (m_participant)
        m_participant->setOthers(others, now);
}

void StrategyEnd::begin(const EventCpo& action, LocalTime now)
{
    if (m_participant)
        m_participant->act(action, now);
}

void StrategyEnd::forget(ObjectId object)
{
    if (m_participant)
        m_participant->forget(object);
}

void StrategyEnd::receive(std::span<const std::byte> bytes, LocalTime now)
{
    if (m_participant)
        m_participant->receive(kStarHost, bytes, now);
}

std::vector<std::vector<std::byte>> StrategyEnd::takeDue(LocalTime now)
{
    std::vector<std::vector<std::byte>> due;
    if (!m_participant)
        return due;
    m_participant->advance(now);
    for (StarDatagram& datagram : m_participant->take())
        due.push_back(std::move(datagram.bytes));
    return due;
}

LocalTime StrategyEnd::nextDue() const
{
    if (!m_participant)
        return LocalTime::max();
    return m_participant->hasOutgoing() ? LocalTime::min() : m_participant->nextWake();
}

const RelayedView* StrategyEnd::view() const
{
    return m_participant ? m_participant->view() : nullptr;
}

const ProbeTrigger* StrategyEnd::triggerTo(ParticipantId other) const
{
    return m_participant ? m_participant->triggerTo(other) : nullptr;
}

void StrategyHost::choose(const StrategyChoice& choice, LocalTime now)
{
    m_own.choose(choice, {kStarHost, without(m_participants, kStarHost)}, now);
    m_relayed = isRelayed(choice) ? &syncStrategy(choice.kind) : nullptr;
    m_relay = m_relayed ? m_relayed->makeHost(m_participants, now) : nullptr;
    m_outgoing.clear();
}

void StrategyHost::setParticipants(std::vector<ParticipantId> participants, LocalTime now)
{
    if (participants == m_participants)
        return;
    m_participants = std::move(participants);
    m_own.setOthers(without(m_participants, kStarHost), now);
    if (m_relayed)
        m_relay = m_relayed->makeHost(m_participants, now);
    std::erase_if(m_outgoing, [this](const auto& entry) {
        return std::ranges::find(m_participants, entry.first) == m_participants.end();
    });
}

void StrategyHost::begin(const EventCpo& action, LocalTime now)
{
    m_own.begin(action, now);
    advance(now);
}

void StrategyHost::receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now)
{
    if (!m_relay)
        return;
    m_relay->receive(from, bytes, now);
    m_relay->advance(now);
    forward(now);
}

void StrategyHost::advance(LocalTime now)
{
    if (!m_relay)
        return;
    for (const auto& bytes : m_own.takeDue(now))
        m_relay->receive(kStarHost, bytes, now);
    m_relay->advance(now);
    forward(now);
}

void StrategyHost::forward(LocalTime now)
{
    for (StarDatagram& datagram : m_relay->take()) {
        if (datagram.to == kStarHost)
            m_own.receive(datagram.bytes, now);
        else
            m_outgoing[datagram.to].push_back(std::move(datagram.bytes));
    }
}

std::vector<std::vector<std::byte>> StrategyHost::takeDue(ParticipantId to)
{
    const auto found = m_outgoing.find(to);
    return found == m_outgoing.end() ? std::vector<std::vector<std::byte>>{}
                                     : std::move(m_outgoing.extract(found).mapped());
}

LocalTime StrategyHost::nextDue() const
{
    if (!m_outgoing.empty())
        return LocalTime::min();
    return m_relay ? std::min(m_own.nextDue(), m_relay->nextWake()) : m_own.nextDue();
}

} // namespace carina
