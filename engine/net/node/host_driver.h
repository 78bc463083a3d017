#pragma once

#include "engine/io/fact_store/store_writer.h"
#include "engine/net/node/external_clock.h"
#include "engine/net/node/host_entry.h"
#include "engine/net/node/host_view.h"
#include "engine/net/node/node_board.h"
#include "engine/net/node/node_driver.h"
#include "engine/net/objects/publications.h"

namespace carina
{

/// The host's driver: judges proposals, has each fact stored on disk and then distributes it.
///
/// What is decided in a turn, and while the disk works on an earlier turn, is one transaction.
/// Until it is stored nobody hears of it, this node included.
class HostDriver : public NodeDriver
{
public:
    /// Facts that are decided and not stored, from which on proposals are refused.
    static constexpr std::size_t kMostUnstored = 4096;
    /// By at most so much a slow disk puts off the effect of a change.
    static constexpr Duration kLongestStoring = std::chrono::seconds{2};

    /// Opens the session in the store, or creates one. @param board outlives the driver.
    [[nodiscard]] static Result<std::unique_ptr<HostDriver>> open(const HostSettings& settings,
                                                                  std::unique_ptr<FactStore> store,
                                                                  NodeBoard& board, LocalTime now);

    [[nodiscard]] const HostAccess& access() const { return *m_access; }

    /// Waits until everything decided so far is stored or given up.
    void waitForDisk(LocalTime now);

    void cameFrom(const SourcePrefix& source) override { m_source = source; }
    void connected(PeerAddress peer, const Credential& who, LocalTime now) override;
    void disconnected(PeerAddress peer, LocalTime now) override;
    void refused(const Error& why, LocalTime now) override;
    void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) override;
    void propose(StationId station, FactBody body, LocalTime now) override;
    void publish(ObjectKind kind, std::string name, PoseSource newest) override;
    void publishShape(ObjectKind kind, ShapeSource shape) override;
    void act(ObjectId object, const ObjectAction& action, LocalTime now) override;
    Datagrams advance(LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;
    std::vector<PeerAddress> takeEnded() override;
    void onNews(std::function<void()> callback) override
    {
        m_writer->onReport(std::move(callback));
    }
    Datagrams close(LocalTime now) override;

private:
    HostDriver(SessionAuthority authority, NodeBoard& board, LocalTime now);

    void startCore(const std::string& sessionId, std::vector<FactRecord> log, Duration clockOffset);
    [[nodiscard]] Result<void> begin(const HostSettings& settings, const std::string& sessionId,
                                     LocalTime now);
    [[nodiscard]] Result<void> chooseStrategy(const HostSettings& settings, LocalTime now);
    void joinItself(const std::string& name, LocalTime now);

    [[nodiscard]] Result<FactNumber> decide(const Proposal& proposal, LocalTime now);
    [[nodiscard]] Result<void> decideForPeer(const ProposalRecord& proposal, LocalTime now);
    [[nodiscard]] Result<void> decideByHost(StationId station, FactBody body, LocalTime now);
    /// The first of the facts that are decided are on disk.
    void stored(std::size_t count, LocalTime now);
    /// The facts that are decided cannot be stored: everything is as it was before them.
    void giveUp(const Error& why, LocalTime now);

    void left(ParticipantId participant, Leave why, LocalTime now);
    /// What has to be done before a fact is entered.
    /// @returns TooMuchSent while the key of a role's last code is being derived; then it must not
    ///          be.
    [[nodiscard]] Result<void> prepare(const Fact& fact);
    /// What a fact about who takes part makes the host do.
    void carryOut(const FactBody& body);
    /// For the case that the host was ended between a ban and its revocation.
    [[nodiscard]] Result<void> revokeBanned() const;
    /// Tells those who were removed, and ends their connections.
    void dismissRemoved(LocalTime now);
    /// Replaces the tokens of those whose programs were displaced.
    void replaceTokens(const std::vector<SyncHost::Output::Displaced>& displaced, LocalTime now);

    /// Enters that participants of the last run who did not return have left.
    void dropAbsent(LocalTime now);

    void resumeActions(const std::vector<EventCpo>& actions, LocalTime now);
    /// Hands to the disk what there is, unless it is at work.
    void handOver(LocalTime now);
    /// Takes what the disk reports.
    void takeReport(LocalTime now);
    void take(const StoreReport& report, LocalTime now);
    /// The actions that were handed over are not stored.
    void keepAgain(const Error& why, LocalTime now);
    void takeMoved(const Result<std::optional<std::filesystem::path>>& moved);
    void share(const SharedObject& object);
    void compareViews(LocalTime now);
    [[nodiscard]] std::optional<ActedPose> shownPose(ObjectId object, SessionTime t) const;
    void sendOwnStreams(LocalTime now);
    void show(LocalTime now);
    [[nodiscard]] std::vector<PathReport> measurePaths(LocalTime now) const;

    FactLedger m_ledger;
    std::unique_ptr<StoreWriter> m_writer;
    LocalTime m_handedOverAt{};
    Duration m_storing{}; // how long the last facts took
    NodeBoard& m_board;
    std::unique_ptr<SyncHost> m_core;
    ExternalClock m_externalClock;
    std::unique_ptr<HostAccess> m_access;
    SourcePrefix m_source{};   // of the next path
    PeerAddress m_speaker = 0; // sender of the datagram being handled
    HostPaths m_paths{[this](PeerAddress path) { return m_core->peers().contains(path); },
                      [this](PeerAddress path) { return m_core->isArriving(path); }};
    std::unique_ptr<HostEntry> m_entry;
    std::vector<PeerAddress> m_ended; // paths of those who exceeded their budget
    Datagrams m_tokens;               // to be sent once they are on disk
    Datagrams m_tokensHandedOver;     // these are with the writer
    Datagrams m_tokensStored;
    LocalTime m_nextSecrets = LocalTime::min(); // when they may be written unless awaited
    std::vector<ParticipantId> m_removed;       // to be told
    Publications m_publications;
    ShownViews m_views{[this](ObjectId id, SessionTime t) { return shownPose(id, t); },
                       [this](ObjectId id, SessionTime t) {
                           return m_publications.measured(id, m_ledger.stored().state(),
                                                          ParticipantId{0}, t);
                       }};
    LocalTime m_nextViews = LocalTime::max();
    std::uint16_t m_epoch = 0;
    std::map<ObjectId, EventCpo> m_unkept; // not stored on disk yet
    std::map<ObjectId, EventCpo> m_kept;   // these are with the writer
    LocalTime m_nextKeep{};
    LocalTime m_returnsEnd; // until then participants of the last run may return
    LocalTime m_nextWatch{};
    std::optional<Error> m_storeFault; // what happened to the store, until the end
    std::optional<Error> m_refusal;
    HostView m_hostView;
};

} // namespace carina
