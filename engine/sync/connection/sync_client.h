#pragma once

#include "engine/sync/actions/client_actions.h"
#include "engine/sync/clock/fitted_clock.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/facts/fact_acknowledgement.h"
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

/// One participant's end of a session, without socket, clock or thread: the caller passes in bytes
/// and local time, and takes out datagrams for the host, facts and stream samples.
///
/// It repeats Hello at growing intervals until it is welcomed, keeps its copy of the log, repeats
/// its proposals and estimates the session clock. When the host is silent or no longer has the
/// connection, it reconnects and continues from the end of its log.
class SyncClient
{
public:
    enum class State : std::uint8_t { Connecting, Connected, Away, Closed };

    static constexpr Duration kFirstHelloWait = std::chrono::milliseconds{25};
    static constexpr Duration kLastHelloWait = std::chrono::milliseconds{250};
    /// Interval of probes while the clock is being set.
    static constexpr Duration kAcquireInterval = std::chrono::milliseconds{20};

    struct Output {
        std::vector<std::vector<std::byte>> datagrams;
        /// The host has another session: discard everything taken before.
        bool startedAfresh = false;
        std::vector<FactRecord> facts; ///< the next ones in order
        std::vector<StreamSample> streams;
        std::vector<RefusedProposal> refused;
        std::vector<ShownPose> shown; ///< by the owners of the objects
    };

    /// @param join the fact that this participant joins, proposed with every Hello
    /// @param firstConnection random, so that datagrams to an earlier run of the program are not
    ///        accepted
    /// @param station that is wanted (Hello::station), until it is first welcomed: later it may
    /// have
    ///        been moved to another one
    SyncClient(ProposalRecord join, std::uint32_t firstConnection, LocalTime now,
               std::string station = {});

    /// A datagram from the host's address. A malformed one is dropped.
    void receive(std::span<const std::byte> bytes, LocalTime now);
    /// Sends what is due; called after everything else and at nextWake().
    void advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const;
    [[nodiscard]] Output take() { return std::exchange(m_output, {}); }

    /// A reading of this program's clock against one that is disciplined from outside; it is sent
    /// to the host.
    void readExternal(const ExternalTime& reading, LocalTime now)
    {
        m_external = reading;
        m_externalRead = now;
        m_tellExternal = true;
    }
    void propose(ProposalRecord proposal, LocalTime now);
    /// Sets the ownership of an object, taken from the facts; samples from others than its owner
    /// are dropped.
    void share(ObjectId object, const Ownership& ownership);
    /// The session's strategy and the other participants who are present, taken from the facts.
    void setStrategy(const StrategyChoice& choice, LocalTime now)
    {
        m_actions.setStrategy(choice, now, sessionTime(now));
    }
    void setOthers(std::vector<ParticipantId> others, LocalTime now)
    {
        m_actions.setOthers(std::move(others), now);
    }
    /// What was shown of an own object, for all others to compare with.
    void tellShown(const ShownPose& shown)
    {
        if (m_state == State::Connected)
            m_shown.push_back(shown);
    }
    /// Queues a sample of an own object for the next tick.
    void publish(StationId station, const StreamCpo& cpo);
    /// There is a new path to the host: sends Hello at once unless connected.
    void greetNow(LocalTime now);
    /// Begins an action on an own object, now; also while the host is away.
    /// @returns what SharedActions::begun does; NotPermitted before the clock is set.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, LocalTime now);
    /// Sends Goodbye; nothing is received or sent after it.
    void leave(LocalTime now);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] ParticipantId self() const { return m_self; }
    /// Whether the log is complete up to its end at the last Welcome.
    [[nodiscard]] bool isCaughtUp() const;
    [[nodiscard]] FactNumber lastFact() const { return m_facts.last(); }
    [[nodiscard]] const std::deque<ProposalRecord>& waiting() const
    {
        return m_proposals.waiting();
    }
    [[nodiscard]] const FittedClock& clock() const { return m_clock; }
    [[nodiscard]] const SharedActions& actions() const { return m_actions.shared(); }
    /// How the session's strategy itself probes the path to another participant; nullptr for one
    /// that measures none (StarParticipant::triggerTo).
    [[nodiscard]] const ProbeTrigger* strategyTriggerTo(ParticipantId other) const
    {
        return m_actions.triggerTo(other);
    }
    [[nodiscard]] const PeerLink& link() const { return m_link; }
    /// Why the host does not admit this participant, or ended its connection. After Removed, Banned
    /// and UsedElsewhere the client is closed and does not ask again.
    [[nodiscard]] const std::optional<Error>& helloRefused() const { return m_helloRefused; }

private:
    struct Visitor;

    void welcomed(const Welcome& welcome, LocalTime now);
    void startAfresh();
    void reconnect(LocalTime now);
    void takeFact(const FactRecord& fact, LocalTime now);
    void takeStreams(const StreamGroup& group, LocalTime now);
    [[nodiscard]] std::vector<WireRecord> dueStreams(LocalTime now);
    [[nodiscard]] std::optional<SessionTime> sessionTime(LocalTime t) const;
    void addProbe(const RoundTrip& trip, LocalTime now);
    void sendHello(LocalTime now);
    void sendDue(LocalTime now);
    void send(std::span<const WireRecord> records, bool isProbe, LocalTime now);
    [[nodiscard]] Duration keepAlive() const;

    ProposalRecord m_join;
    std::string m_station; // wanted; empty once welcomed
    State m_state = State::Connecting;
    PeerLink m_link;
    LocalTime m_nextHello;
    Duration m_helloWait = kFirstHelloWait;
    std::optional<Error> m_helloRefused;

    SessionKey m_session{};
    ParticipantId m_self = kNobody;
    std::uint16_t m_epoch = 0;
    FactNumber m_logAtWelcome;

    FactReceiver m_facts;
    FactAcknowledgement m_acknowledgement;
    ProposalQueue m_proposals;
    FittedClock m_clock;
    std::optional<ExternalTime> m_external;
    LocalTime m_externalRead{};
    bool m_tellExternal = false;
    StreamTable m_table;
    StreamTick m_tick;
    std::map<ObjectId, StreamSample> m_outgoing; // the newest of each
    std::vector<ShownPose> m_shown;              // to be sent
    ClientActions m_actions;
    Output m_output;
};

} // namespace carina
