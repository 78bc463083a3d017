#include "engine/sync/facts/fact_replication.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kProposalEnvelopeBytes = 13;

} // namespace

FactRange FactSender::takeDue(FactNumber logEnd, Duration roundTrip, LocalTime now)
{
    if (m_sent > m_acknowledged && now >= m_repeatAt) {
        m_sent = m_acknowledged;
        m_repeatAfter = std::min(2 * m_repeatAfter, kLastRepeat);
    }
    const FactNumber end = windowEnd(logEnd);
    const FactRange due{FactNumber{m_sent.value + 1}, end};
    // The time runs from the oldest that is under way, or newer ones would put it off for ever.
    if (m_sent == m_acknowledged)
        m_repeatAt = now + roundTrip + m_repeatAfter;
    m_sent = std::max(m_sent, end);
    return due;
}

LocalTime FactSender::nextDue(FactNumber logEnd) const
{
    if (m_sent < windowEnd(logEnd))
        return LocalTime::min();
    return m_sent > m_acknowledged ? m_repeatAt : LocalTime::max();
}

void FactSender::acknowledge(FactNumber last, Duration roundTrip, LocalTime now)
{
    if (last <= m_acknowledged || last > m_sent)
        return;
    m_acknowledged = last;
    m_repeatAfter = kFirstRepeat;
    m_repeatAt = now + roundTrip + m_repeatAfter;
}

FactNumber FactSender::windowEnd(FactNumber logEnd) const
{
    return {std::min(logEnd.value, m_acknowledged.value + kFactWindow)};
}

std::vector<FactRecord> FactReceiver::take(FactRecord fact)
{
    std::vector<FactRecord> inOrder;
    if (fact.number <= m_last || fact.number.value > m_last.value + kFactWindow)
        return inOrder;
    m_early.insert_or_assign(fact.number, std::move(fact));
    for (auto next = m_early.begin();
         next != m_early.end() && next->first.value == m_last.value + 1;
         next = m_early.erase(next)) {
        m_last = next->first;
        inOrder.push_back(std::move(next->second));
    }
    return inOrder;
}

void ProposalQueue::add(ProposalRecord proposal, LocalTime now)
{
    m_waiting.push_back(std::move(proposal));
    m_nextDue = now;
}

std::optional<ProposalRecord> ProposalQueue::settle(ProposalId id)
{
    const auto found = std::ranges::find(m_waiting, id, &ProposalRecord::id);
    if (found == m_waiting.end())
        return std::nullopt;
    std::optional<ProposalRecord> settled = std::move(*found);
    m_waiting.erase(found);
    return settled;
}

std::vector<ProposalRecord> ProposalQueue::takeDue(std::size_t bytes, LocalTime now)
{
    std::vector<ProposalRecord> due;
    if (now < nextDue())
        return due;
    for (const ProposalRecord& proposal : m_waiting) {
        const std::size_t size = kProposalEnvelopeBytes + proposal.body.size();
        if (!due.empty() && size > bytes)
            break;
        bytes -= std::min(bytes, size);
        due.push_back(proposal);
    }
    m_nextDue = now + kRepeat;
    return due;
}

LocalTime ProposalQueue::nextDue() const
{
    return m_waiting.empty() ? LocalTime::max() : m_nextDue;
}

} // namespace carina
