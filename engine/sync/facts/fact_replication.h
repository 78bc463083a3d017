#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/facts/fact_record.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>

namespace carina
{

/// How far ahead of the last fact in order a client keeps facts, and the most that a host has sent
/// and not acknowledged.
inline constexpr std::uint64_t kLargestFactWindow = 4096;

/// The host's side of replicating the log to one peer: sends facts in order and repeats
/// unacknowledged ones with exponential backoff.
///
/// A long log, for a late joiner, is sent in bursts, as fast as the path takes it: the window of
/// unacknowledged facts grows and shrinks by slow start, congestion avoidance and fast recovery as
/// in RFC 5681 and RFC 6582 (NewReno), counted in facts.
class FactSender
{
public:
    static constexpr Duration kFirstRepeat = std::chrono::milliseconds{50};
    static constexpr Duration kLastRepeat = std::chrono::seconds{1};
    static constexpr std::uint64_t kFirstWindow = 64;
    /// About the facts of a datagram: by so much a window grows in a round trip once it has shrunk.
    static constexpr std::uint64_t kWindowStep = 16;
    /// Bytes of facts sent at once, which the receive buffer of a socket holds; more follow after
    /// kBurstInterval.
    static constexpr std::size_t kBurstBytes = 32'768;
    static constexpr Duration kBurstInterval = std::chrono::milliseconds{4};
    /// Acknowledgements of the same fact that tell that the next one is lost.
    static constexpr int kDuplicates = 3;

    explicit FactSender(FactNumber alreadyThere)
        : m_acknowledged{alreadyThere}, m_sent{alreadyThere}, m_furthest{alreadyThere}
    {
    }

    /// Whether so many bytes may be sent now. @param isBehind whether more follow them
    using MaySend = std::function<bool(std::size_t bytes, bool isBehind)>;

    /// Facts to send now; they count as sent.
    /// @param log all facts, from number 1
    /// @param roundTrip added to the time after which facts are repeated
    /// @param maySend asked once where some are due, which are put off where it says no; none: all
    ///        may be sent
    [[nodiscard]] std::span<const FactRecord> takeDue(std::span<const FactRecord> log,
                                                      Duration roundTrip, LocalTime now,
                                                      const MaySend& maySend = {});
    /// When takeDue returns the next facts, if no acknowledgement arrives before.
    [[nodiscard]] LocalTime nextDue(FactNumber logEnd) const;
    /// @param last newest fact acknowledged; ignored where it was never sent
    void acknowledge(FactNumber last, Duration roundTrip, LocalTime now);

    [[nodiscard]] FactNumber acknowledged() const { return m_acknowledged; }

private:
    [[nodiscard]] FactNumber windowEnd(FactNumber logEnd) const;
    /// Those of these facts that make a burst, if they may be sent; none otherwise.
    [[nodiscard]] std::span<const FactRecord> permitted(std::span<const FactRecord> facts,
                                                        bool isBehind, LocalTime now,
                                                        const MaySend& maySend);
    void acknowledgedAgain(Duration roundTrip, LocalTime now);
    void growWindow(std::uint64_t acknowledged);

    FactNumber m_acknowledged;
    FactNumber m_sent;     // m_acknowledged <= m_sent
    FactNumber m_furthest; // ever sent: m_sent goes back when all is repeated
    Duration m_repeatAfter = kFirstRepeat;
    LocalTime m_repeatAt{}; // for the facts sent and not acknowledged
    LocalTime m_nextBurst = LocalTime::min();

    std::uint64_t m_window = kFirstWindow;
    std::uint64_t m_slowStartUntil = kLargestFactWindow; // the window
    int m_duplicates = 0;
    FactNumber m_recovered;       // up to here a loss is being repaired
    bool m_repeatsOldest = false; // a burst from the oldest is due
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
    std::map<FactNumber, FactRecord> m_early; // at most kLargestFactWindow ahead
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
