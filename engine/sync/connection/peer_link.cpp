#include "engine/sync/connection/peer_link.h"

#include "engine/sync/wire/sequence.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kRoundTripsKept = 64;
// Longer ones come from an echo that is not ours, or of long ago.
constexpr Duration kLongestRoundTrip = std::chrono::seconds{10};

} // namespace

BundleHeader PeerLink::nextHeader(LocalTime now)
{
    BundleHeader header;
    header.connection = m_connection;
    header.sequence = ++m_sequence;
    header.sentAt = now.time_since_epoch() + m_clockOffset;
    if (m_newest && now - m_newest->at <= kLongestHold)
        header.echo = ClockEcho{m_newest->peerSent, now - m_newest->at};
    m_lastSent = now;
    return header;
}

std::optional<RoundTrip> PeerLink::heard(const BundleHeader& header, LocalTime now)
{
    m_lastHeard = now;
    m_loss.arrived(header.sequence);
    if (m_newest && !isAfter(header.sequence, m_newest->sequence))
        return std::nullopt;
    m_newest = Arrival{header.sequence, header.sentAt, now};
    if (!header.echo)
        return std::nullopt;
    const LocalTime sent{header.echo->sentAt - m_clockOffset};
    const Duration length = now - sent - header.echo->hold;
    const bool isFirstAnswer = !m_answered || sent > *m_answered;
    if (sent < m_begun || length < Duration{} || length > kLongestRoundTrip || !isFirstAnswer)
        return std::nullopt;
    m_answered = sent;
    m_roundTrips.push_back(length);
    if (m_roundTrips.size() > kRoundTripsKept)
        m_roundTrips.pop_front();
    // A host asks for these for each peer in each turn, and they change only here.
    const auto [shortest, longest] = std::ranges::minmax(m_roundTrips);
    m_shortest = shortest;
    m_longest = longest;
    return RoundTrip{sent, header.sentAt, header.echo->hold, length};
}

std::optional<Duration> PeerLink::newestRoundTrip() const
{
    return m_roundTrips.empty() ? std::nullopt : std::optional{m_roundTrips.back()};
}

} // namespace carina
