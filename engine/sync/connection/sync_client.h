#pragma once

#include "engine/sync/actions/client_actions.h"
#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/facts/fact_replication.h"
#include "engine/sync/streams/stream_table.h"
#include "engine/sync/streams/stream_tick.h"

#include <map>
#include <span>

namespace carina
{

/// A proposal that the host did not enter into the log.
struct RefusedProposal {
    ProposalRecord proposal;
    Errc reason;
};

/// One participant's end of a session, without socket, clock or thread: whoever drives it brings
/// bytes and local time in, and takes datagrams for the host, facts and stream samples out.
///
/// It says Hello until it is welcomed, more and more slowly; keeps its copy of the log; repeats its
/// proposals; estimates the session clock; and begins anew, from where its log ends, when the host
/// falls silent or has forgotten it.
class SyncClient
{
public:
    enum class State : std::uint8_t { Connecting, Connected, Away, Closed };

    static constexpr Duration kFirstHelloWait = std::chrono::milliseconds{25};
    static constexpr Duration kLastHelloWait = std::chrono::milliseconds{250};
    /// Between probes while the clock is being set.
    static constexpr Duration kAcquireInterval = std::chrono::milliseconds{20};

    struct Output {
        std::vector<std::vector<std::byte>> datagrams;
        bool startedAfresh = false;    ///< another session: what came of the last is void
        std::vector<FactRecord> facts; ///< next in order
        std::vector<StreamSample> streams;
        std::vector<RefusedProposal> refused;
    };

    /// @param join the fact that this participant comes in, proposed with every Hello
    /// @param firstConnection at random, so that an earlier program's datagrams are not taken for
    ///        this one's
    SyncClient(ProposalRecord join, std::uint32_t firstConnection, LocalTime now);

    /// A datagram from the host's address. What is malformed is dropped.
    void receive(std::span<const std::byte> bytes, LocalTime now);
    /// Sends what is due; called after everything else and at nextWake().
    void advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const;
    [[nodiscard]] Output take() { return std::exchange(m_output, {}); }

    void propose(ProposalRecord proposal, LocalTime now);
    /// Tells of a shared object, as the facts do; samples of others than its owner are dropped.
    void share(ObjectId object, const Ownership& ownership);
    /// Sends a sample of an object of its own with the next tick.
    void publish(StationId station, const StreamCpo& cpo);
    /// There is a new path to the host: greets it at once where it is not connected.
    void greetNow(LocalTime now);
    /// Takes an action on an object of its own, now; also while the host is away.
    /// @returns what SharedActions::begun does; NotPermitted before the clock is set.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, LocalTime now);
    /// Says goodbye; nothing is received or sent any more.
    void leave(LocalTime now);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] ParticipantId self() const { return m_self; }
    /// The whole log that the host had at the last Welcome is here.
    [[nodiscard]] bool isCaughtUp() const;
    [[nodiscard]] FactNumber lastFact() const { return m_facts.last(); }
    [[nodiscard]] const std::deque<ProposalRecord>& waiting() const
    {
        return m_proposals.waiting();
    }
    [[nodiscard]] const FittedClock& clock() const { return m_clock; }
    [[nodiscard]] const SharedActions& actions() const { return m_actions.shared(); }
    [[nodiscard]] const PeerLink& link() const { return m_link; }
    /// Why the host does not let this participant in.
    [[nodiscard]] std::optional<Errc> helloRefused() const { return m_helloRefused; }

private:
    struct Visitor;

    void welcomed(const Welcome& welcome, LocalTime now);
    void startAfresh();
    void reconnect(LocalTime now);
    void takeFact(const FactRecord& fact);
    void takeStreams(const StreamGroup& group, LocalTime now);
    [[nodiscard]] std::vector<WireRecord> dueStreams(LocalTime now);
    [[nodiscard]] std::optional<SessionTime> sessionTime(LocalTime t) const;
    void addProbe(const RoundTrip& trip, LocalTime now);
    void sendHello(LocalTime now);
    void sendDue(LocalTime now);
    void send(std::span<const WireRecord> records, LocalTime now);
    [[nodiscard]] Duration keepAlive() const;

    ProposalRecord m_join;
    State m_state = State::Connecting;
    PeerLink m_link;
    LocalTime m_nextHello;
    Duration m_helloWait = kFirstHelloWait;
    std::optional<Errc> m_helloRefused;

    SessionKey m_session{};
    ParticipantId m_self = kNobody;
    std::uint16_t m_epoch = 0;
    FactNumber m_logAtWelcome;

    FactReceiver m_facts;
    bool m_acknowledge = false;
    ProposalQueue m_proposals;
    FittedClock m_clock;
    StreamTable m_table;
    StreamTick m_tick;
    std::map<ObjectId, StreamSample> m_outgoing; // the newest of each
    ClientActions m_actions;
    Output m_output;
};

} // namespace carina
