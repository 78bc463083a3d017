#pragma once

#include "engine/sync/actions/event_table.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/strategies/strategy.h"

#include <map>

namespace carina
{

/// The host of the session-clock strategy, whose clock is the session clock. It forwards each new
/// action at once, to every participant until it is acknowledged, and answers probes at once.
class SessionClockHost final : public StarNode
{
public:
    /// As SyncStrategy::makeHost.
    [[nodiscard]] static std::unique_ptr<StarNode> make(std::uint16_t participants, LocalTime now);

    SessionClockHost(std::uint16_t participants, LocalTime now);

    void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) override;
    void advance(LocalTime now) override;
    void readExternal(const ExternalTime& reading, LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;

private:
    struct Peer {
        PeerLink link;
        EventRepeater events{false};
        std::vector<WireRecord> acks{};
        bool answer = false; ///< a datagram is to be sent at once
    };

    void take(ParticipantId from, const EventCpo& event, LocalTime now);

    std::map<ParticipantId, Peer> m_peers;
    EventTable m_table;
};

} // namespace carina
