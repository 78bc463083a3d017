#include "engine/sync/facts/fact_replication.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kProposalEnvelopeBytes = 13;
constexpr std::size_t kFactEnvelopeBytes = 39;

std::size_t bytesOf(const FactRecord& fact) { return kFactEnvelopeBytes + fact.body.size(); }

} // namespace

std::span<const FactRecord> FactSender::permitted(std::span<const FactRecord> facts, bool isBehind,
                                                  LocalTime now, const MaySend& maySend)
{
    std::size_t bytes = 0;
    std::size_t count = 0;
    while (count < facts.size() && (count == 0 || bytes + bytesOf(facts[count]) <= kBurstBytes))
        bytes += bytesOf(facts[count++]);
    if (!maySend || maySend(bytes, isBehind || count < facts.size()))
        return facts.first(count);
    m_nextBurst = now + kBurstInterval;
    return {};
}

std::span<const FactRecord> FactSender::takeDue(std::span<const FactRecord> log, Duration roundTrip,
                                                LocalTime now, const MaySend& maySend)
{
    if (m_sent > m_acknowledged && now >= m_repeatAt) {
        m_sent = m_acknowledged;
        m_repeatAfter = std::min(2 * m_repeatAfter, kLastRepeat);
        m_slowStartUntil = std::max(m_window / 2, kFirstWindow);
        m_window = kFirstWindow;
        m_recovered = m_acknowledged;
        m_duplicates = 0;
        m_repeatsOldest = false;
        m_nextBurst = LocalTime::min();
    }
    if (std::exchange(m_repeatsOldest, false)) {
        const std::uint64_t end = std::min(m_sent.value, m_acknowledged.value + kWindowStep);
        return permitted(log.subspan(m_acknowledged.value, end - m_acknowledged.value),
                         end < log.size(), now, maySend);
    }
    const FactNumber end = windowEnd(FactNumber{log.size()});
    if (m_sent >= end || now < m_nextBurst)
        return {};
    const auto due = permitted(log.subspan(m_sent.value, end.value - m_sent.value),
                               end.value < log.size(), now, maySend);
    if (due.empty())
        return {};
    // The time runs from the oldest that is under way, or newer ones would put it off for ever.
    if (m_sent == m_acknowledged)
        m_repeatAt = now + roundTrip + m_repeatAfter;
    m_sent.value += due.size();
    m_furthest = std::max(m_furthest, m_sent);
    if (m_sent.value < log.size()) // a single fact is not held up
        m_nextBurst = now + kBurstInterval;
    return due;
}

LocalTime FactSender::nextDue(FactNumber logEnd) const
{
    if (m_repeatsOldest)
        return LocalTime::min();
    const LocalTime repeat = m_sent > m_acknowledged ? m_repeatAt : LocalTime::max();
    return m_sent < windowEnd(logEnd) ? std::min(m_nextBurst, repeat) : repeat;
}

void FactSender::acknowledge(FactNumber last, Duration roundTrip, LocalTime now)
{
    if (last < m_acknowledged || last > m_furthest)
        return;
    if (last == m_acknowledged)
        return acknowledgedAgain(roundTrip, now);
    growWindow(last.value - m_acknowledged.value);
    m_acknowledged = last;
    m_sent = std::max(m_sent, last);
    m_duplicates = 0;
    m_repeatsOldest = last < m_recovered; // more than one was lost
    m_repeatAfter = kFirstRepeat;
    m_repeatAt = now + roundTrip + m_repeatAfter;
}

void FactSender::acknowledgedAgain(Duration roundTrip, LocalTime now)
{
    if (m_sent == m_acknowledged || m_acknowledged < m_recovered || ++m_duplicates < kDuplicates)
        return;
    m_duplicates = 0;
    m_recovered = m_sent;
    m_repeatsOldest = true;
    m_window = m_slowStartUntil = std::max(m_window / 2, kFirstWindow);
    m_repeatAt = std::max(m_repeatAt, now + roundTrip + m_repeatAfter);
}

void FactSender::growWindow(std::uint64_t acknowledged)
{
    const std::uint64_t step =
        m_window < m_slowStartUntil
            ? acknowledged
            : std::max(std::uint64_t{1}, kWindowStep * acknowledged / m_window);
    m_window = std::min(m_window + step, kLargestFactWindow);
}

FactNumber FactSender::windowEnd(FactNumber logEnd) const
{
    return {std::min(logEnd.value, m_acknowledged.value + m_window)};
}

std::vector<FactRecord> FactReceiver::take(FactRecord fact)
{
    std::vector<FactRecord> inOrder;
    if (fact.number <= m_last || fact.number.value > m_last.value + kLargestFactWindow)
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
