#pragma once

#include "engine/core/result.h"
#include "engine/sync/actions/host_actions.h"
#include "engine/sync/clock/peer_clock.h"
#include "engine/sync/connection/arrivals.h"
#include "engine/sync/connection/host_budgets.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/connection/peer_traffic.h"
#include "engine/sync/connection/shown_relay.h"
#include "engine/sync/facts/fact_replication.h"
#include "engine/sync/streams/host_streams.h"

#include <functional>
#include <set>
#include <span>

namespace carina
{

/// Why a participant is no longer here.
enum class Leave : std::uint8_t {
    Meant,  ///< a Goodbye, or by the host
    Silence ///< nothing is heard of the program, or its path ended without a Goodbye
};

/// Callbacks into the session, which decides. What it decides becomes a fact of the log later, when
/// it is on disk, by SyncHost::append, or is given up by SyncHost::giveUp.
struct HostRules {
    /// The participant that a join would be admitted as; changes nothing.
    std::function<Result<Identity>(const Hello& hello, LocalTime)> identify;
    /// Admits a participant. A repeated join gets the fact it already has. Nothing where the
    /// program is to ask again.
    std::function<Result<std::optional<Admission>>(const Hello& hello, LocalTime)> admit;
    /// Whether a proposal was decided before, so that there is or will be a fact of it.
    std::function<bool(ProposalId)> isSettled;
    /// Decides on a new proposal.
    std::function<Result<void>(const ProposalRecord& proposal, LocalTime)> decide;
    /// A participant sent Goodbye or timed out.
    std::function<void(ParticipantId, Leave, LocalTime)> left;
    /// Whether a participant may move objects, including its own: by its role, and unless muted.
    std::function<bool(ParticipantId)> mayAct;
    /// What is taken from a participant.
    std::function<PeerLimits(ParticipantId)> limits;
    /// The station that a participant is at, of which alone its streams are taken.
    std::function<StationId(ParticipantId)> stationOf;
    /// What the participants behind this path and others share; null where they share nothing.
    std::function<std::shared_ptr<SharedBudget>(PeerAddress)> sharedBudget;
    /// Whether a participant is sent the streams of all stations; else those of its own.
    std::function<bool(ParticipantId)> watchesAll = [](ParticipantId) { return false; };
    /// Whether the objects of a participant come first among the streams: it treats a patient.
    std::function<bool(ParticipantId)> comesFirst = [](ParticipantId) { return false; };
};

/// The session host's end, without socket, clock or thread: replicates the log to every peer,
/// forwards streams and actions, and provides the session clock.
class SyncHost
{
public:
    /// A program from which a datagram arrived less than this ago keeps its participant against
    /// another program with the same name and role.
    static constexpr Duration kNameHeld = std::chrono::milliseconds{600};
    /// A program is known to be alive beside another with the same secret when it is heard this
    /// long after the other asked to come in: longer than a datagram is on its way, and less than
    /// the time for which a name is held. A program that was restarted, or moved, is heard no more
    /// on its old path.
    static constexpr Duration kAliveBeside = std::chrono::milliseconds{500};
    /// With more participants all that goes out waits for the next tick of the streams, so that
    /// each fact, action and answer does not cost a datagram to everybody: 8 ms later on average.
    static constexpr std::size_t kFewPeers = 32;
    /// Who comes late does not wait for ticks while it catches up, if so many do at most.
    static constexpr std::size_t kFewBehind = 8;
    /// How far a sample may be ahead of the session, beside half the round trip of its path: a
    /// clock is not better known than that.
    static constexpr Duration kLargestAhead = std::chrono::milliseconds{5};
    /// Upper limit of what half the round trip adds to it: who answers late has a long one.
    static constexpr Duration kLargestAheadByPath = std::chrono::milliseconds{50};
    /// Upper limit of slowestPath(), by which effect times are delayed.
    static constexpr Duration kLongestPath = std::chrono::seconds{1};
    /// The same for the paths of those who may not act: who only watches must not slow down all.
    static constexpr Duration kLongestPathOfWatchers = std::chrono::milliseconds{200};
    /// Bytes of the log in a second that are sent to all those together who come late and have not
    /// caught up, to each as much: the newest facts of the others, and their samples, do not wait
    /// for them.
    static constexpr double kCatchUpBytes = 16e6;
    /// To each of them at once.
    static constexpr double kCatchUpBytesAtOnce = 2.0 * FactSender::kBurstBytes;

    struct Output {
        struct Addressed {
            PeerAddress to;
            std::vector<std::byte> bytes;
        };
        std::vector<Addressed> datagrams;
        std::vector<StreamSample> streams; ///< of other participants
        std::vector<ShownPose> shown;      ///< by the owners of the objects
        std::vector<PeerAddress> ended;    ///< paths that are to be closed after the datagrams
        struct Displaced {
            PeerAddress address;
            ParticipantId participant;
        };
        /// Paths whose program was told UsedElsewhere, for another one proved the same participant.
        std::vector<Displaced> displaced;
    };

    struct Peer {
        PeerLink link;
        ParticipantId participant;
        std::uint16_t epoch;
        ProposalId join; ///< identifies one run of a program
        FactSender facts;
        PeerBudget& budget;  ///< of the participant, in the host
        bool welcome = true; ///< a Welcome is to be sent
        bool answer = false; ///< a datagram is to be sent at once
        std::vector<WireRecord> outbox{};
        PeerClock clock{};
        PeerTraffic traffic{};
        TokenBucket catchUp{}; ///< of what all share who have not caught up

        void heard(const BundleHeader& header, SessionTime session, LocalTime now)
        {
            if (const auto trip = link.heard(header, now))
                clock.add(*trip, session);
        }
    };

    /// @param log of the session so far
    /// @param clockOffset session time less local time
    SyncHost(const SessionKey& session, std::vector<FactRecord> log, Duration clockOffset,
             HostRules rules);

    void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now);
    /// Sends what is due; called after everything else and at nextWake().
    void advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const;
    [[nodiscard]] Output take() { return std::exchange(m_output, {}); }

    /// A reading of the host's clock against one that is disciplined from outside; it is sent to
    /// everybody.
    void readExternal(const ExternalTime& reading, LocalTime now);
    /// Appends a fact that is on disk now. @pre its number is the next.
    void append(const FactRecord& fact);
    /// Tells who waits for a fact that it could not be stored.
    void giveUp(const FactRecord& fact, Errc why, LocalTime now);
    /// Whether a datagram of this peer that is no part of a bundle is within its budget; counts it.
    [[nodiscard]] bool takesDatagram(PeerAddress from, std::size_t bytes, LocalTime now);
    /// What was shown of an object of the host, for all others to compare with.
    void tellShown(const ShownPose& shown) { forward(shown, ParticipantId{0}); }
    /// Sets the ownership of an object, taken from the facts.
    void share(ObjectId object, const Ownership& ownership);
    /// The session's strategy, taken from the facts.
    void setStrategy(const StrategyChoice& choice, LocalTime now)
    {
        m_actions.setStrategy(choice, now, sessionTime(now));
    }
    /// Begins an action on an object of the host, now.
    /// @returns what SharedActions::begun does.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, LocalTime now)
    {
        return m_actions.act(object, action, sessionTime(now), now);
    }
    /// See HostActions::restore and takeChanged.
    void restore(const EventCpo& event) { m_actions.restore(event); }
    [[nodiscard]] std::vector<EventCpo> takeChanged() { return m_actions.takeChanged(); }
    /// Queues a sample of an object of the host for the next tick.
    void publish(const StreamSample& sample, LocalTime now);
    /// Tells a participant's program why it is out, and ends its connection; its path stays, so
    /// that it can ask again if the datagram is lost. The rule `left` is not called.
    void dismiss(ParticipantId participant, const Error& why, LocalTime now);
    /// The path to this address has ended.
    void drop(PeerAddress address, LocalTime now);
    /// Sends Goodbye to every peer.
    void close(LocalTime now);

    [[nodiscard]] SessionTime sessionTime(LocalTime t) const
    {
        return SessionTime{t.time_since_epoch() + m_clockOffset};
    }
    [[nodiscard]] LocalTime localTime(SessionTime t) const
    {
        return LocalTime{t.time_since_epoch() - m_clockOffset};
    }
    [[nodiscard]] const std::map<PeerAddress, Peer>& peers() const { return m_peers; }
    /// Whether a program of this participant is connected or admitted.
    [[nodiscard]] bool isHere(ParticipantId participant) const;
    /// Whether somebody comes in over this path, and is not welcomed yet.
    [[nodiscard]] bool isArriving(PeerAddress from) const { return m_arrivals.contains(from); }
    [[nodiscard]] const SharedActions& actions() const { return m_actions.shared(); }
    /// How the session's strategy itself probes the path to another participant; nullptr for one
    /// that measures none (StarParticipant::triggerTo).
    [[nodiscard]] const ProbeTrigger* strategyTriggerTo(ParticipantId other) const
    {
        return m_actions.triggerTo(other);
    }
    [[nodiscard]] const std::vector<FactRecord>& log() const { return m_log; }
    /// Half the longest recent round trip of any peer, at most kLongestPath; of those who may not
    /// act, kLongestPathOfWatchers.
    [[nodiscard]] Duration slowestPath() const;

private:
    struct Visitor;

    void take(PeerAddress from, std::span<const std::byte> bytes, LocalTime now);
    void hello(PeerAddress from, const BundleHeader& header, const Hello& hello, LocalTime now);
    [[nodiscard]] Result<std::optional<Admission>> admit(PeerAddress from, const Hello& hello,
                                                         LocalTime now);
    void welcomeArrivals(LocalTime now);
    void welcome(PeerAddress address, const Arrival& arrival, LocalTime now);
    void remove(PeerAddress address, Leave why, LocalTime now);
    /// Passes on what its owner showed of an object, when that is due.
    void relayShown(LocalTime now);
    void forward(const ShownPose& shown, ParticipantId from);
    /// Of which station a participant is sent the streams; kAllStations: of all.
    [[nodiscard]] StationId watchedBy(ParticipantId participant) const;
    [[nodiscard]] StreamSource sourceOf(const Peer& peer) const;
    /// Begins a tick of the streams.
    void gatherStreams(LocalTime now);
    void forgetParticipant(ParticipantId participant, LocalTime now);
    void propose(Peer& peer, ProposalRecord proposal, LocalTime now);
    void takeStreams(Peer& peer, const StreamGroup& group, LocalTime now);
    void dropSilentPeers(LocalTime now);
    void endExceedingPeers(LocalTime now);
    /// Tells the budgets that are shared how many share them.
    void countMembers(LocalTime now);
    /// Whether a program that asks from this address is kept out by another one of the participant.
    [[nodiscard]] bool isTaken(PeerAddress from, const Identity& who, ProposalId join,
                               LocalTime now);
    /// Ends the other programs of a participant whom `from` proved to be.
    void displace(PeerAddress from, ParticipantId participant, LocalTime now);
    void sendDue(PeerAddress to, Peer& peer, bool tick, LocalTime now);
    void answerStranger(PeerAddress to, std::uint32_t connection, const WireRecord& record,
                        LocalTime now);
    /// Sends what is due to everybody.
    void serve(LocalTime now);
    [[nodiscard]] bool waitsForTicks() const { return m_peers.size() > kFewPeers; }
    /// For how long what goes out may wait for a tick.
    [[nodiscard]] Duration longestWait() const
    {
        return waitsForTicks() ? StreamTick::kPeriod : Duration{};
    }
    [[nodiscard]] bool isBehind(const Peer& peer) const
    {
        return peer.facts.acknowledged().value + FactSender::kFirstWindow < m_log.size();
    }
    /// Whether anybody is sent the log between ticks, too.
    [[nodiscard]] bool fewCatchUp() const { return m_behind > 0 && m_behind <= kFewBehind; }
    /// Whether a peer is: of few who have not caught up.
    [[nodiscard]] bool catchesUp(const Peer& peer) const { return fewCatchUp() && isBehind(peer); }
    /// Between ticks: sends what is due to those who catch up.
    void serveBetween(LocalTime now);
    /// How many have not caught up.
    [[nodiscard]] std::size_t countBehind() const;
    /// Whether so many bytes of the log may be sent to a peer now.
    [[nodiscard]] bool maySendLog(Peer& peer, std::size_t bytes, bool isBehind,
                                  LocalTime now) const;
    /// When a peer is next to be sent something other than streams and actions.
    [[nodiscard]] LocalTime nextDueTo(const Peer& peer) const;
    [[nodiscard]] FactNumber logEnd() const { return {m_log.size()}; }

    SessionKey m_session;
    std::vector<FactRecord> m_log;
    Duration m_clockOffset;
    std::optional<ExternalTime> m_external; // less session time
    LocalTime m_externalRead{};
    HostRules m_rules;
    HostBudgets m_budgets;
    std::map<PeerAddress, Peer> m_peers;
    /// No peer is silent for kPeerTimeout before this.
    LocalTime m_nobodySilentBefore = LocalTime::max();
    /// Peers that sent far too much since the last turn.
    std::set<PeerAddress> m_exceeding;
    std::size_t m_behind = 0; ///< peers that have not caught up, in the last turn for all
    Arrivals m_arrivals;
    /// Since when a program asks to come in as a participant of whom another is here.
    std::map<PeerAddress, LocalTime> m_asksSince;
    ShownRelay m_shown;
    HostStreams m_streams;
    HostActions m_actions;
    Output m_output;
};

} // namespace carina
