#pragma once

#include "engine/sync/actions/host_actions.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/strategies/strategy.h"

#include <map>

namespace carina
{

/// The host of the session-clock strategies, whose clock is the session clock. It forwards each new
/// action at once, to every participant until it is acknowledged, and answers probes at once. Who
/// acts on an object first owns it.
class SessionClockHost final : public StarNode
{
public:
    /// As SyncStrategy::makeHost.
    [[nodiscard]] static std::unique_ptr<StarNode>
    make(const std::vector<ParticipantId>& participants, LocalTime now);

    /// The same for local lag.
    [[nodiscard]] static std::unique_ptr<StarNode>
    makeWithLag(const std::vector<ParticipantId>& participants, LocalTime now);

    SessionClockHost(const std::vector<ParticipantId>& participants, bool hasLag, LocalTime now);

    void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) override;
    void advance(LocalTime now) override;
    void readExternal(const ExternalTime& reading, LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override { return m_actions.nextDue(); }

private:
    struct Peer {
        PeerLink link;
        bool answer = false; ///< a datagram is to be sent at once
        std::vector<WireRecord> outbox{};
    };

    void take(ParticipantId from, const EventCpo& event, LocalTime now);

    std::map<ParticipantId, Peer> m_peers;
    std::map<ObjectId, ParticipantId> m_owners;
    HostActions m_actions;
};

} // namespace carina
