#include "engine/sync/clock/peer_clock.h"

namespace carina
{

void PeerClock::add(const RoundTrip& trip, SessionTime session)
{
    if (trip.peerSent > kLargestReading || trip.peerSent < -kLargestReading)
        return;
    const Duration half = trip.length / 2;
    const SessionTime middle = session - (trip.length + trip.hold) / 2;
    const LocalTime middleAtPeer{trip.peerSent - trip.hold / 2};
    m_newest = middle;
    m_newestAtPeer = middleAtPeer;
    m_clock.addProbe({middleAtPeer - half, middle, middle, middleAtPeer + half});
}

LocalTime PeerClock::peerTime(SessionTime session) const
{
    return m_newestAtPeer + (session - m_newest);
}

std::optional<Duration> PeerClock::offset(SessionTime session) const
{
    if (!m_clock.mapping())
        return std::nullopt;
    const LocalTime there = peerTime(session);
    return m_clock.mapping()->at(there).time_since_epoch() - there.time_since_epoch();
}

double PeerClock::uncertainty(SessionTime session) const
{
    return m_clock.uncertainty(peerTime(session));
}

Duration PeerClock::bound(SessionTime session) const { return m_clock.bound(peerTime(session)); }

} // namespace carina
