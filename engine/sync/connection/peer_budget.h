#pragma once

#include "engine/sync/connection/shared_budget.h"

#include <memory>

namespace carina
{

/// What the host takes from a participant in a second; twice as much in a burst.
struct PeerLimits {
    double datagrams = 0.0;
    double bytes = 0.0;
    double comings = 0.0;   ///< times to come in, beyond the first; each makes two facts
    double proposals = 0.0; ///< each may become a fact on disk
    double events = 0.0;    ///< starts, changes and beats of actions on objects
    double samples = 0.0;   ///< of streams
    double messages = 0.0;  ///< of the session's strategy; as many answers to probes again
};

/// The budget of a participant at the host, sans time: what exceeds it is not taken. Excess is
/// counted in seconds' worth of the limit and forgotten at one second a second, so that a program
/// that goes a little over its limit is only slowed, and one that goes far over it is found within
/// seconds.
class PeerBudget
{
public:
    /// Excess from which the participant is disconnected.
    static constexpr double kMostExcess_s = 10.0;
    /// Refusals per second that are answered; others are dropped.
    static constexpr double kAnswers = 20.0;
    /// Proposals per second of which it is looked whether they were decided before. A program sends
    /// all that it waits for again with each new one, and ten times a second.
    static constexpr double kHeardProposals = 2000.0;
    /// Facts of a coming: it joined, and later it left. Shared with others as proposals are.
    static constexpr double kFactsOfComing = 2.0;

    /// Bytes of the log that are sent to it in a second, and at once: all of a long log to who
    /// comes late, and not again to who asks for it over and over.
    static constexpr double kLogBytes = 512.0 * 1024.0;
    static constexpr double kLogBytesAtOnce = 8.0 * 1024.0 * 1024.0;

    explicit PeerBudget(const PeerLimits& limits) : m_limits{limits} {}

    /// The participant comes in. @param others with whom it shares a budget; null: with nobody
    void comes(std::shared_ptr<SharedBudget> others, LocalTime now);
    /// It is gone; it may come again.
    void goes(LocalTime now);
    [[nodiscard]] SharedBudget* shared() const { return m_shared.get(); }

    enum class Verdict : std::uint8_t {
        Taken,
        Later,  ///< by what it shares with others; no excess, and it may ask again
        Refused ///< by its own limit
    };

    /// What its place exceeds is not taken either, and is no excess of its own.
    [[nodiscard]] bool takesDatagram(std::size_t bytes, LocalTime now);
    /// Whether one more proposal is looked at; what exceeds this is no excess.
    [[nodiscard]] bool hearsProposal(LocalTime now)
    {
        return m_heard.take(1.0, kHeardProposals, now);
    }
    [[nodiscard]] Verdict takesProposal(LocalTime now)
    {
        return takesFacts(m_proposals, 1.0, m_limits.proposals, 1.0, now);
    }
    /// Uses up no proposal of its own: who has just come in can propose.
    [[nodiscard]] Verdict takesComing(LocalTime now)
    {
        return takesFacts(m_comings, 1.0, m_limits.comings, kFactsOfComing, now);
    }
    [[nodiscard]] bool takesEvent(LocalTime now);
    [[nodiscard]] bool takesSamples(std::size_t count, LocalTime now);
    /// Messages beyond the limit are lost, as the strategies must bear, and are no excess: how many
    /// there are, the session decides and not the participant.
    [[nodiscard]] bool takesMessage(LocalTime now)
    {
        return m_messages.take(1.0, m_limits.messages, now);
    }
    /// The same for answers to probes, which others ask for: they use up nothing else.
    [[nodiscard]] bool takesProbeAnswer(LocalTime now)
    {
        return m_probeAnswers.take(1.0, m_limits.messages, now);
    }
    /// Whether so much of the log may be sent to it.
    [[nodiscard]] bool takesLog(std::size_t bytes, LocalTime now)
    {
        return m_log.takeOf(kLogBytesAtOnce, static_cast<double>(bytes), kLogBytes, now);
    }
    /// Whether one more refusal may be answered.
    [[nodiscard]] bool answers(LocalTime now) { return m_answers.take(1.0, kAnswers, now); }

    [[nodiscard]] bool isFarExceeded() const { return m_excess_s > kMostExcess_s; }
    /// Forgets the excess.
    void pardon() { m_excess_s = 0.0; }

private:
    [[nodiscard]] bool counted(TokenBucket& bucket, double amount, double perSecond, LocalTime now);
    /// @param facts that will come of it, of those it shares with others
    [[nodiscard]] Verdict takesFacts(TokenBucket& bucket, double amount, double perSecond,
                                     double facts, LocalTime now);

    PeerLimits m_limits;
    TokenBucket m_datagrams;
    TokenBucket m_bytes;
    TokenBucket m_comings;
    TokenBucket m_proposals;
    TokenBucket m_events;
    TokenBucket m_samples;
    TokenBucket m_messages;
    TokenBucket m_probeAnswers;
    TokenBucket m_heard;
    TokenBucket m_answers;
    TokenBucket m_log;
    std::shared_ptr<SharedBudget> m_shared;
    SharedBudget::Share m_share;
    double m_excess_s = 0.0;
    LocalTime m_excessAt{};
};

} // namespace carina
