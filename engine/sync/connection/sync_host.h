#pragma once

#include "engine/core/result.h"
#include "engine/sync/actions/host_actions.h"
#include "engine/sync/clock/peer_clock.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/facts/fact_replication.h"
#include "engine/sync/streams/host_streams.h"

#include <functional>
#include <span>

namespace carina
{

/// What the session decides when somebody comes in.
struct Admission {
    ParticipantId participant;
    /// The fact that the participant came in. Its number, cut to 16 bits, is the epoch of the
    /// participant's streams: later each time, also across a restart of the host.
    FactRecord fact;
};

/// The session behind the host: it judges, and has on disk what it returns.
struct HostRules {
    /// Who a join would be; changes nothing.
    std::function<Result<ParticipantId>(const ProposalRecord& join, LocalTime)> identify;
    /// Lets a participant in. The fact may be an old one, where the same join is repeated.
    std::function<Result<Admission>(const ProposalRecord& join, LocalTime)> admit;
    /// Enters a proposal into the log. The fact may be an old one, where it is repeated.
    std::function<Result<FactRecord>(const ProposalRecord& proposal, LocalTime)> decide;
    /// A participant said goodbye or fell silent.
    std::function<void(ParticipantId, LocalTime)> left;
    /// Whether a participant's role lets it act on objects, its own included.
    std::function<bool(ParticipantId)> mayAct;
};

/// The session host's end, without socket, clock or thread: keeps every peer's copy of the log
/// complete, passes streams on, and is the session clock.
class SyncHost
{
public:
    /// A program that was heard of less long ago keeps its name against another program's.
    static constexpr Duration kNameHeld = std::chrono::milliseconds{600};
    /// Effect times do not wait longer than this for a slow path.
    static constexpr Duration kLongestPath = std::chrono::seconds{1};

    struct Output {
        struct Addressed {
            PeerAddress to;
            std::vector<std::byte> bytes;
        };
        std::vector<Addressed> datagrams;
        std::vector<StreamSample> streams; ///< of other participants
    };

    struct Peer {
        PeerLink link;
        ParticipantId participant;
        std::uint16_t epoch;
        ProposalId join; ///< tells one run of a program from the next
        FactSender facts;
        bool welcome = true; ///< is due
        bool answer = false; ///< is due, with whatever there is
        std::vector<WireRecord> outbox{};
        PeerClock clock{};

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

    /// A fact that the host itself decided and has on disk. One that is in the log already changes
    /// nothing. @pre it is at most the next.
    void append(const FactRecord& fact);
    /// Tells of a shared object, as the facts do.
    void share(ObjectId object, const Ownership& ownership);
    /// Takes an action on an object of the host's own, now.
    /// @returns what SharedActions::begun does.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, LocalTime now)
    {
        return m_actions.act(object, action, sessionTime(now), now);
    }
    /// See HostActions.
    void restore(const EventCpo& event) { m_actions.restore(event); }
    [[nodiscard]] std::vector<EventCpo> takeChanged() { return m_actions.takeChanged(); }
    /// Sends a sample of an object of the host's own with the next tick.
    void publish(const StreamSample& sample, LocalTime now);
    /// Nobody will be heard from this address any more.
    void drop(PeerAddress address, LocalTime now);
    /// Says goodbye to everyone.
    void close(LocalTime now);

    [[nodiscard]] SessionTime sessionTime(LocalTime t) const
    {
        return SessionTime{t.time_since_epoch() + m_clockOffset};
    }
    [[nodiscard]] const std::map<PeerAddress, Peer>& peers() const { return m_peers; }
    [[nodiscard]] const SharedActions& actions() const { return m_actions.shared(); }
    [[nodiscard]] const std::vector<FactRecord>& log() const { return m_log; }
    /// How long a datagram to the slowest peer takes at worst.
    [[nodiscard]] Duration slowestPath() const;

private:
    struct Visitor;

    void hello(PeerAddress from, const BundleHeader& header, const Hello& hello, LocalTime now);
    [[nodiscard]] Result<Admission> admit(PeerAddress from, const Hello& hello, LocalTime now);
    void remove(PeerAddress address, LocalTime now);
    void forgetParticipant(ParticipantId participant);
    void propose(Peer& peer, ProposalRecord proposal, LocalTime now);
    void takeStreams(const Peer& peer, const StreamGroup& group, LocalTime now);
    void dropSilentPeers(LocalTime now);
    void sendDue(PeerAddress to, Peer& peer, bool tick, LocalTime now);
    void answerStranger(PeerAddress to, std::uint32_t connection, const WireRecord& record,
                        LocalTime now);
    [[nodiscard]] FactNumber logEnd() const { return {m_log.size()}; }

    SessionKey m_session;
    std::vector<FactRecord> m_log;
    Duration m_clockOffset;
    HostRules m_rules;
    std::map<PeerAddress, Peer> m_peers;
    HostStreams m_streams;
    HostActions m_actions;
    Output m_output;
};

} // namespace carina
