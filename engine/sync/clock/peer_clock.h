#pragma once

#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"

namespace carina
{

/// Clock of a participant and path to it, estimated by the session host.
///
/// The datagrams from which a participant estimates the host's clock let the host estimate the
/// participant's. With t1 and t2 the times on the host's clock when it sent a datagram and received
/// the answer, p the time on the participant's clock when it answered, and h the time for which it
/// held the datagram:
///
///     offset = (t1 + t2)/2 - (p - h/2)        round trip = (t2 - t1) - h
///
/// FittedClock fits a line to these. One-way delays are half the round trip.
class PeerClock
{
public:
    /// Larger clock readings are ignored, so that no difference of two overflows: 73 years.
    static constexpr Duration kLargestReading{1LL << 61};

    /// @param trip as measured by the host
    /// @param session session time at which the trip ended
    void add(const RoundTrip& trip, SessionTime session);

    /// What clocks disciplined from outside say at the host, less session time, and at the
    /// participant, less its local time.
    /// @param age of the host's; that of the participant is fresh
    void setExternal(const ExternalTime& host, const ExternalTime& participant, Duration age)
    {
        m_clock.setExternal(externalOffset(host, participant, age, m_newestAtPeer));
    }

    /// h_0, H_p, sigma and gamma_0 of the path (ProbeTrigger), by the rule of an idle participant.
    [[nodiscard]] const ProbeTrigger& trigger() const { return m_clock.trigger(); }
    /// Session time less the participant's local time; nothing before the first fit.
    [[nodiscard]] std::optional<Duration> offset(SessionTime session) const;
    /// Standard error of the offset, seconds (FittedClock::uncertainty). @pre offset()
    [[nodiscard]] double uncertainty(SessionTime session) const;
    /// Upper bound of the error of the offset (FittedClock::bound). @pre offset()
    [[nodiscard]] Duration bound(SessionTime session) const;

    /// As FittedClock::external.
    [[nodiscard]] const std::optional<ExternalVerdict>& external() const
    {
        return m_clock.external();
    }

private:
    [[nodiscard]] LocalTime peerTime(SessionTime session) const;

    FittedClock m_clock; // the participant's local time to session time
    SessionTime m_newest{};
    LocalTime m_newestAtPeer{};
};

} // namespace carina
