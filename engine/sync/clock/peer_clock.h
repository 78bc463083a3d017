#pragma once

#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"

namespace carina
{

/// The clock of a participant and the path to it, as the session host sees them.
///
/// The same exchange that tells a participant of the host's clock tells the host of the
/// participant's. With t1 and t2 on the host's clock when it sent and heard again, and h the time
/// the participant held the datagram until it answered at p on its own clock:
///
///     offset = (t1 + t2)/2 - (p - h/2)        round trip = (t2 - t1) - h
///
/// from which FittedClock makes a line. One-way delays are half the round trip.
class PeerClock
{
public:
    /// Clocks are believed up to this reading, so that no difference of two overflows: 73 years.
    static constexpr Duration kLargestReading{1LL << 61};

    /// @param trip as measured by the host
    /// @param session at the host when the trip ended
    void add(const RoundTrip& trip, SessionTime session);

    /// h_0, H_p, sigma and gamma_0 of the path, by the rule of an idle participant.
    [[nodiscard]] const ProbeTrigger& trigger() const { return m_clock.trigger(); }
    /// Session time less the participant's local time; nothing before the first fit.
    [[nodiscard]] std::optional<Duration> offset(SessionTime session) const;
    /// Standard error of the offset, seconds (FittedClock::uncertainty). @pre offset()
    [[nodiscard]] double uncertainty(SessionTime session) const;
    /// Nothing makes the error of the offset larger (FittedClock::bound). @pre offset()
    [[nodiscard]] Duration bound(SessionTime session) const;

private:
    [[nodiscard]] LocalTime peerTime(SessionTime session) const;

    FittedClock m_clock; // the participant's local time to session time
    SessionTime m_newest{};
    LocalTime m_newestAtPeer{};
};

} // namespace carina
