#pragma once

#include "engine/net/node_board.h"
#include "engine/net/node_driver.h"
#include "engine/net/publications.h"
#include "engine/sync/sync_client.h"

namespace carina
{

/// A participant's part: applies the facts that come and shares its own objects.
class ClientDriver : public NodeDriver
{
public:
    /// @param board outlives the driver
    ClientDriver(const JoinSettings& settings, PeerAddress host, NodeBoard& board, LocalTime now);

    void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) override;
    void propose(StationId station, FactBody body, LocalTime now) override;
    void publish(StationId station, ObjectKind kind, std::string name, PoseSource newest) override;
    Datagrams advance(LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;
    Datagrams close(LocalTime now) override;

private:
    void sendOwnStreams(LocalTime now);
    void startAfresh();
    /// @returns false for a fact that nobody can follow; this node then leaves.
    [[nodiscard]] bool apply(const FactRecord& record, LocalTime now);
    void share(ObjectId object, ParticipantId owner);
    [[nodiscard]] Datagrams addressed(std::vector<std::vector<std::byte>> datagrams) const;
    [[nodiscard]] NodeBoard::Link link(LocalTime now) const;
    void show(LocalTime now);

    PeerAddress m_host;
    NodeBoard& m_board;
    SyncClient m_core;
    Publications m_publications;
    SessionState m_state;
    std::optional<Error> m_refusal;
    std::shared_ptr<const SessionState> m_shownState;
};

} // namespace carina
