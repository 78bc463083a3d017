#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/connection/loss_window.h"
#include "engine/sync/wire/datagram.h"

#include <deque>
#include <optional>

namespace carina
{

/// A peer from which nothing arrived for this long is away.
inline constexpr Duration kPeerTimeout = std::chrono::seconds{3};
/// Longest interval between datagrams to a peer, for liveness and as clock probes.
inline constexpr Duration kKeepAlive = std::chrono::milliseconds{250};

/// A measured round trip, with the timestamps that the clock estimate needs.
struct RoundTrip {
    LocalTime sent;      ///< by this node
    Duration peerSent{}; ///< on the peer's clock
    Duration hold{};     ///< from the peer's receiving to its sending
    Duration length{};   ///< without the hold
};

/// One end of a connection: assigns sequence numbers, measures round trips and notes when the peer
/// was last heard.
class PeerLink
{
public:
    /// @param clockOffset this node's clock in headers less its local time
    PeerLink(std::uint32_t connection, Duration clockOffset, LocalTime now)
        : m_connection{connection},
          m_clockOffset{clockOffset},
          m_begun{now},
          m_lastHeard{now},
          m_lastSent{now}
    {
    }

    [[nodiscard]] std::uint32_t connection() const { return m_connection; }

    /// The header of the next datagram to the peer, without flags and sender.
    [[nodiscard]] BundleHeader nextHeader(LocalTime now);

    /// Notes a datagram from the peer. @returns the round trip that it completes, if any. A peer
    /// that sends often echoes the same datagram many times. Only the first echo counts: the others
    /// share its outward delay, and one slow datagram would look like a change of route. An echo of
    /// what this end cannot have sent measures nothing. A peer that answers late on purpose looks
    /// like one far away: what is made of a round trip has to bear that.
    std::optional<RoundTrip> heard(const BundleHeader& header, LocalTime now);

    [[nodiscard]] LocalTime lastHeard() const { return m_lastHeard; }
    [[nodiscard]] LocalTime lastSent() const { return m_lastSent; }
    /// Of the last round trips; nothing before the first.
    [[nodiscard]] std::optional<Duration> shortestRoundTrip() const { return m_shortest; }
    [[nodiscard]] std::optional<Duration> longestRoundTrip() const { return m_longest; }
    [[nodiscard]] std::optional<Duration> newestRoundTrip() const;
    /// Loss of datagrams from the peer; see LossWindow.
    [[nodiscard]] std::optional<double> loss() const { return m_loss.loss(); }

private:
    struct Arrival {
        std::uint32_t sequence;
        Duration peerSent;
        LocalTime at;
    };

    std::uint32_t m_connection;
    Duration m_clockOffset;
    LocalTime m_begun; // nothing was sent before
    LocalTime m_lastHeard;
    LocalTime m_lastSent;
    std::uint32_t m_sequence = 0;
    std::optional<Arrival> m_newest;
    std::optional<LocalTime> m_answered; // when the newest datagram that was echoed was sent
    std::deque<Duration> m_roundTrips;   // the last kRoundTripsKept
    std::optional<Duration> m_shortest;  // of these
    std::optional<Duration> m_longest;
    LossWindow m_loss;
};

} // namespace carina
