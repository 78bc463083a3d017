#pragma once

#include "engine/core/session_time.h"
#include "engine/sync/connection/loss_window.h"
#include "engine/sync/wire/datagram.h"

#include <deque>
#include <optional>

namespace carina
{

/// Nothing heard for so long: the peer is away.
inline constexpr Duration kPeerTimeout = std::chrono::seconds{3};
/// A datagram goes out at least this often, for liveness and as a probe of the clock.
inline constexpr Duration kKeepAlive = std::chrono::milliseconds{250};

/// A round trip just measured, with what the clock needs to know of it.
struct RoundTrip {
    LocalTime sent;      ///< by this node
    Duration peerSent{}; ///< on the peer's clock
    Duration hold{};     ///< between the peer's receiving and sending
    Duration length{};
};

/// One end of a connection: numbers what it sends, measures round trips and hears whether the other
/// end lives.
class PeerLink
{
public:
    /// @param clockOffset this node's clock in headers less its local time
    PeerLink(std::uint32_t connection, Duration clockOffset, LocalTime now)
        : m_connection{connection}, m_clockOffset{clockOffset}, m_lastHeard{now}, m_lastSent{now}
    {
    }

    [[nodiscard]] std::uint32_t connection() const { return m_connection; }

    /// The header of the next datagram to the peer, but for its flags and sender.
    [[nodiscard]] BundleHeader nextHeader(LocalTime now);

    /// Takes note of a datagram from the peer. @returns the round trip it closes, if it does. A
    /// peer that sends often answers one datagram many times; only the first answer counts, for
    /// they share the way out, and one slow datagram would otherwise look like another route.
    std::optional<RoundTrip> heard(const BundleHeader& header, LocalTime now);

    [[nodiscard]] LocalTime lastHeard() const { return m_lastHeard; }
    [[nodiscard]] LocalTime lastSent() const { return m_lastSent; }
    /// Of the recent ones; nothing before the first.
    [[nodiscard]] std::optional<Duration> shortestRoundTrip() const;
    [[nodiscard]] std::optional<Duration> longestRoundTrip() const;
    [[nodiscard]] std::optional<Duration> newestRoundTrip() const;
    /// Of what the peer sent; see LossWindow.
    [[nodiscard]] std::optional<double> loss() const { return m_loss.loss(); }

private:
    struct Arrival {
        std::uint32_t sequence;
        Duration peerSent;
        LocalTime at;
    };

    std::uint32_t m_connection;
    Duration m_clockOffset;
    LocalTime m_lastHeard;
    LocalTime m_lastSent;
    std::uint32_t m_sequence = 0;
    std::optional<Arrival> m_newest;
    std::optional<LocalTime> m_answered; // when the newest that was answered was sent
    std::deque<Duration> m_roundTrips;   // the last kRoundTripsKept
    LossWindow m_loss;
};

} // namespace carina
