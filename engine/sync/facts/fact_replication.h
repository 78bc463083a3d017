#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/facts/fact_record.h"

#include <deque>
#include <map>
#include <optional>

namespace carina
{

/// Send window: facts that may be sent to one peer and not acknowledged. It also paces the log that
/// a late joiner gets.
inline constexpr std::uint64_t kFactWindow = 64;

/// Facts from first to last; empty where last is before first.
struct FactRange {
    FactNumber first{1};
    FactNumber last{0};
};

/// The host's side of replicating the log to one peer: sends facts in order and repeats
/// unacknowledged ones with exponential backoff.
class FactSender
{
public:
    static constexpr Duration kFirstRepeat = std::chrono::milliseconds{50};
    static constexpr Duration kLastRepeat = std::chrono::seconds{1};

    explicit FactSender(FactNumber alreadyThere)
        : m_acknowledged{alreadyThere}, m_sent{alreadyThere}
    {
    }

    /// Facts to send now of a log that ends at `logEnd`; they count as sent.
    /// @param roundTrip added to the time after which facts are repeated
    [[nodiscard]] FactRange takeDue(FactNumber logEnd, Duration roundTrip, LocalTime now);
    /// When takeDue returns the next facts, if no acknowledgement arrives before.
    [[nodiscard]] LocalTime nextDue(FactNumber logEnd) const;
    /// @param last newest fact acknowledged; ignored where it was never sent
    void acknowledge(FactNumber last, Duration roundTrip, LocalTime now);

    [[nodiscard]] FactNumber acknowledged() const { return m_acknowledged; }

private:
    [[nodiscard]] FactNumber windowEnd(FactNumber logEnd) const;

    FactNumber m_acknowledged;
    FactNumber m_sent; // m_acknowledged <= m_sent
    Duration m_repeatAfter = kFirstRepeat;
    LocalTime m_repeatAt{}; // for the facts sent and not acknowledged
};

/// The client's side: puts facts into order.
class FactReceiver
{
public:
    /// The last fact received in order.
    [[nodiscard]] FactNumber last() const { return m_last; }

    /// @returns the facts that are now next in order: none for a duplicate or an early fact,
    ///          several for a fact that fills a gap.
    [[nodiscard]] std::vector<FactRecord> take(FactRecord fact);

private:
    FactNumber m_last;
    std::map<FactNumber, FactRecord> m_early; // at most kFactWindow ahead
};

/// Proposals of this node that the host has neither entered into the log nor refused, oldest first.
///
/// Each datagram starts with the oldest proposal and holds no gaps, so that the host receives them
/// in order whatever is lost.
class ProposalQueue
{
public:
    static constexpr Duration kRepeat = std::chrono::milliseconds{100};

    void add(ProposalRecord proposal, LocalTime now);
    /// Removes a proposal that was entered or refused. @returns it, if it was in the queue.
    std::optional<ProposalRecord> settle(ProposalId id);
    /// Makes all proposals due at `now`: the host may be another one.
    void repeatAt(LocalTime now) { m_nextDue = now; }
    void clear() { m_waiting.clear(); }

    [[nodiscard]] const std::deque<ProposalRecord>& waiting() const { return m_waiting; }

    /// The oldest proposals that fit together into `bytes` on the wire, at least one; none before
    /// they are due.
    [[nodiscard]] std::vector<ProposalRecord> takeDue(std::size_t bytes, LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

private:
    std::deque<ProposalRecord> m_waiting;
    LocalTime m_nextDue{};
};

} // namespace carina
