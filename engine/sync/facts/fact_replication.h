#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/facts/fact_record.h"

#include <deque>
#include <map>
#include <optional>

namespace carina
{

/// Facts that may be under way to one peer at a time; a late joiner's log is paced by it.
inline constexpr std::uint64_t kFactWindow = 64;

/// Facts first to last, empty when last is before first.
struct FactRange {
    FactNumber first{1};
    FactNumber last{0};
};

/// The host's side of one peer's copy of the log: sends it in order and repeats, ever more slowly,
/// what is not acknowledged.
class FactSender
{
public:
    static constexpr Duration kFirstRepeat = std::chrono::milliseconds{50};
    static constexpr Duration kLastRepeat = std::chrono::seconds{1};

    explicit FactSender(FactNumber alreadyThere)
        : m_acknowledged{alreadyThere}, m_sent{alreadyThere}
    {
    }

    /// What to send now of a log that ends with `logEnd`; it counts as sent.
    /// @param roundTrip added to the time after which facts are repeated
    [[nodiscard]] FactRange takeDue(FactNumber logEnd, Duration roundTrip, LocalTime now);
    /// When takeDue will have something if no acknowledgement comes.
    [[nodiscard]] LocalTime nextDue(FactNumber logEnd) const;
    /// @param last of an acknowledgement; one for facts never sent is ignored
    void acknowledge(FactNumber last, Duration roundTrip, LocalTime now);

    [[nodiscard]] FactNumber acknowledged() const { return m_acknowledged; }

private:
    [[nodiscard]] FactNumber windowEnd(FactNumber logEnd) const;

    FactNumber m_acknowledged;
    FactNumber m_sent; // m_acknowledged <= m_sent
    Duration m_repeatAfter = kFirstRepeat;
    LocalTime m_repeatAt{}; // of what is sent and not acknowledged
};

/// A client's side: puts facts into order.
class FactReceiver
{
public:
    /// The last that came in order.
    [[nodiscard]] FactNumber last() const { return m_last; }

    /// @returns the facts that are now next in order: none for one that was there or that came
    ///          early, several for one that fills a gap.
    [[nodiscard]] std::vector<FactRecord> take(FactRecord fact);

private:
    FactNumber m_last;
    std::map<FactNumber, FactRecord> m_early; // at most kFactWindow ahead
};

/// Proposals of this node that the host has neither entered nor refused, oldest first.
///
/// They are sent from the oldest on, so that a datagram with a proposal holds every older one too
/// and the host sees them in order, whatever is lost on the way.
class ProposalQueue
{
public:
    static constexpr Duration kRepeat = std::chrono::milliseconds{100};

    void add(ProposalRecord proposal, LocalTime now);
    /// Forgets a proposal that was entered or refused. @returns it, if it was here.
    std::optional<ProposalRecord> settle(ProposalId id);
    /// Sends everything at once, to a host that may be another.
    void repeatAt(LocalTime now) { m_nextDue = now; }
    void clear() { m_waiting.clear(); }

    [[nodiscard]] const std::deque<ProposalRecord>& waiting() const { return m_waiting; }

    /// The oldest proposals that fit together into `bytes` on the wire, if it is time to send them;
    /// at least one.
    [[nodiscard]] std::vector<ProposalRecord> takeDue(std::size_t bytes, LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

private:
    std::deque<ProposalRecord> m_waiting;
    LocalTime m_nextDue{};
};

} // namespace carina
