#pragma once

#include "engine/core/session_time.h"

#include <cstddef>
#include <optional>

namespace carina
{

/// What the host takes from a participant in a second; twice as much in a burst.
struct PeerLimits {
    double datagrams = 0.0;
    double bytes = 0.0;
    double proposals = 0.0; ///< each may become a fact on disk
    double events = 0.0;    ///< starts, changes and beats of actions on objects
    double samples = 0.0;   ///< of streams
    double messages = 0.0;  ///< of the session's strategy
};

/// A token bucket: holds two seconds' worth, and fills with the passing of time.
class TokenBucket
{
public:
    static constexpr double kBurst_s = 2.0;

    /// Takes an amount if it is there. @param perSecond how fast the bucket fills
    [[nodiscard]] bool take(double amount, double perSecond, LocalTime now);

private:
    double m_used_s = 0.0; ///< taken and not refilled, in seconds of filling
    std::optional<LocalTime> m_at;
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

    explicit PeerBudget(const PeerLimits& limits) : m_limits{limits} {}

    [[nodiscard]] bool takesDatagram(std::size_t bytes, LocalTime now);
    [[nodiscard]] bool takesProposal(LocalTime now);
    [[nodiscard]] bool takesEvent(LocalTime now);
    [[nodiscard]] bool takesSamples(std::size_t count, LocalTime now);
    /// Messages beyond the limit are lost, as the strategies must bear, and are no excess: how many
    /// there are, the session decides and not the participant.
    [[nodiscard]] bool takesMessage(LocalTime now)
    {
        return m_messages.take(1.0, m_limits.messages, now);
    }
    /// Whether one more refusal may be answered.
    [[nodiscard]] bool answers(LocalTime now) { return m_answers.take(1.0, kAnswers, now); }

    [[nodiscard]] bool isFarExceeded() const { return m_excess_s > kMostExcess_s; }

private:
    [[nodiscard]] bool counted(TokenBucket& bucket, double amount, double perSecond, LocalTime now);

    PeerLimits m_limits;
    TokenBucket m_datagrams;
    TokenBucket m_bytes;
    TokenBucket m_proposals;
    TokenBucket m_events;
    TokenBucket m_samples;
    TokenBucket m_messages;
    TokenBucket m_answers;
    double m_excess_s = 0.0;
    LocalTime m_excessAt{};
};

} // namespace carina
