#pragma once

#include "engine/net/entry/client_credentials.h"
#include "engine/net/node/external_clock.h"
#include "engine/net/node/node_board.h"
#include "engine/net/node/node_driver.h"
#include "engine/net/objects/publications.h"
#include "engine/sync/connection/sync_client.h"

namespace carina
{

/// A participant's driver: applies the facts that arrive and shares its own objects.
class ClientDriver : public NodeDriver
{
public:
    /// @param board outlives the driver
    ClientDriver(const JoinSettings& settings, NodeBoard& board, LocalTime now);

    /// The keys that the transport authenticates with.
    [[nodiscard]] ClientCredentials& credentials() { return m_credentials; }

    /// The host is at this place from now on.
    void hostMoved(std::string address, std::uint16_t port)
    {
        m_door.address = std::move(address);
        m_door.port = port;
    }

    void connected(PeerAddress host, const Credential& who, LocalTime now) override;
    void disconnected(PeerAddress host, LocalTime now) override;
    void refused(const Error& why, LocalTime now) override;
    void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) override;
    void propose(StationId station, FactBody body, LocalTime now) override;
    void publish(ObjectKind kind, std::string name, PoseSource newest) override;
    void publishShape(ObjectKind kind, ShapeSource shape) override;
    void act(ObjectId object, const ObjectAction& action, LocalTime now) override;
    Datagrams advance(LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;
    Datagrams close(LocalTime now) override;

private:
    void showDoor();
    void sendOwnStreams(LocalTime now);
    void startAfresh();
    /// @returns false for an invalid fact (see fromRecord); the node then leaves the session.
    [[nodiscard]] bool apply(const FactRecord& record, LocalTime now);
    void share(const SharedObject& object);
    [[nodiscard]] Datagrams addressed(std::vector<std::vector<std::byte>> datagrams) const;
    [[nodiscard]] bool wantsToken() const;
    [[nodiscard]] bool isMuted() const;
    /// What a fact about this participant itself changes here.
    void noteConduct(const FactBody& body);
    void compareViews(LocalTime now);
    [[nodiscard]] std::optional<ActedPose> shownPose(ObjectId object, SessionTime t) const;
    void noteStrategy(const FactBody& body, LocalTime now);
    [[nodiscard]] std::optional<ClockReport> clockReport(LocalTime now) const;
    /// The proposals that wait, as shown last where they are the same.
    [[nodiscard]] std::shared_ptr<const std::vector<FactBody>> pending();
    void show(LocalTime now);

    ClientCredentials m_credentials;
    HostDoor m_door; // without the key
    bool m_expectsCertificate;
    PeerAddress m_host = 0; // the path to it
    LocalTime m_nextTokenRequest{};
    bool m_tokenReplaced = false; // and the new one has not arrived
    std::optional<Error> m_noEntry;
    NodeBoard& m_board;
    SyncClient m_core;
    ExternalClock m_externalClock;
    Publications m_publications;
    ShownViews m_views{[this](ObjectId id, SessionTime t) { return shownPose(id, t); },
                       [this](ObjectId id, SessionTime t) {
                           return m_publications.measured(id, m_state, m_core.self(), t);
                       }};
    LocalTime m_nextViews = LocalTime::max();
    SessionState m_state;
    std::optional<Error> m_refusal;
    std::shared_ptr<const SessionState> m_shownState;
    bool m_hasNewState = true; // not shown yet
    LocalTime m_nextShown = LocalTime::min();
    std::vector<ProposalId> m_shownWaiting; // of m_shownPending
    std::shared_ptr<const std::vector<FactBody>> m_shownPending =
        NodeBoard::none<std::vector<FactBody>>();
};

} // namespace carina
