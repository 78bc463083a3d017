#pragma once

#include "engine/sync/actions/shared_actions.h"
#include "engine/sync/connection/token_bucket.h"
#include "engine/sync/strategies/probe_trigger.h"
#include "engine/sync/strategies/relayed_message.h"
#include "engine/sync/strategies/strategy_end.h"

#include <map>
#include <set>

namespace carina
{

/// Where a datagram comes from or goes to. The transport assigns and interprets the number.
using PeerAddress = std::uint64_t;

/// The session host's end of actions on shared objects: accepts actions from the objects' owners
/// (the host included), forwards each to everybody else until it is acknowledged, and sends late
/// joiners the newest action of every object.
class HostActions
{
public:
    HostActions() { m_actions.setSelf(ParticipantId{0}); }

    /// Longer than half a round trip by what programs need to wake and send.
    static constexpr Duration kLagMargin = std::chrono::milliseconds{2};
    /// Between two tellings of the lag to a participant.
    static constexpr Duration kLagInterval = std::chrono::seconds{1};
    /// Actions of a participant in a second that are forwarded each at once; twice as many in a
    /// burst. What exceeds this goes on together, the newest of each object, once in kTogether.
    static constexpr double kAtOnce = 64.0;
    static constexpr Duration kTogether = std::chrono::milliseconds{16};

    /// The session's strategy, taken from the facts. It goes on with objects of the host as they
    /// are at this session time, where that is known.
    void setStrategy(const StrategyChoice& choice, LocalTime now,
                     std::optional<SessionTime> session = std::nullopt);
    /// The delay of the path to or from a peer.
    void measured(PeerAddress peer, Duration oneWay);

    void join(PeerAddress address, ParticipantId participant, LocalTime now);
    void leave(PeerAddress address, LocalTime now);

    /// Sets the ownership of an object, taken from the facts. Where the owner changed, the action
    /// in force continues under the new ownership (SharedActions::continued); where the object was
    /// put back, it ends.
    void share(ObjectId object, const Ownership& ownership);
    /// Begins an action on an object of the host. @returns what SharedActions::begun does.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, SessionTime session,
                                   LocalTime now);
    /// An action from a peer: acknowledged and forwarded where the peer owns the object under the
    /// epoch of the action; dropped otherwise.
    void take(PeerAddress from, const EventCpo& event, SessionTime session, LocalTime now);
    /// A heartbeat from a peer: counts as a repeat of the action it names where that is the newest
    /// here, and is ignored otherwise.
    void take(PeerAddress from, const EventBeat& beat, SessionTime session, LocalTime now);
    /// A message of the strategy from a peer: dropped where it is an action and the peer may not
    /// act, or not on that object, and where it is to all others and no action. Of probes, and of
    /// answers, at most kFastestProbes a second go from one participant to another. Actions that
    /// come together, one on each object, as snapshots do, count as one; beyond kAtOnce they wait
    /// as those of the session clock do, and those that are replaced meanwhile are lost, as the
    /// strategies must bear.
    /// @param relayed the message, decoded
    void take(PeerAddress from, const RelayedMessage& relayed, const StrategyMessage& message,
              bool mayAct, LocalTime now);
    void acknowledge(PeerAddress from, const EventAck& ack);
    /// Restores an action that was in force before a restart of the host; it continues under the
    /// present ownership. Ignored for an object that is not shared, or was put back since.
    void restore(const EventCpo& event);
    /// The newest action of every object on which it changed since the last call: to be stored, and
    /// given to restore() after a restart.
    [[nodiscard]] std::vector<EventCpo> takeChanged();

    /// Forwards the host's own actions and heartbeats; to be called before takeDue.
    void advance(SessionTime session, LocalTime now);
    /// Acknowledgements and actions to send to a peer now; they count as sent.
    [[nodiscard]] std::vector<WireRecord> takeDue(PeerAddress to, LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

    /// For how long what goes out may wait at the host, which actions with a lag wait for, too.
    void setLongestWait(Duration wait) { m_longestWait = wait; }
    [[nodiscard]] const SharedActions& shared() const { return m_actions; }
    /// How the strategy itself probes the path to another participant (StarParticipant::triggerTo).
    [[nodiscard]] const ProbeTrigger* triggerTo(ParticipantId other) const
    {
        return m_strategy.triggerTo(other);
    }

private:
    struct Peer {
        ParticipantId participant;
        EventRepeater events{false};
        std::vector<WireRecord> acks{};
        Duration delay{};
        LocalTime nextLag = LocalTime::min();
        TokenBucket atOnce{};                   ///< actions that are not put off
        TokenBucket relayedAtOnce{};            ///< the same of messages
        LocalTime relayedAt = LocalTime::min(); ///< when one was taken from it last
        std::set<ObjectId> relayedThen{};       ///< at that time, each once
        /// Messages that are put off until relayedDue, the newest of each object.
        std::map<ObjectId, std::vector<std::byte>> relayed{};
        LocalTime relayedDue = LocalTime::max();
        std::map<ParticipantId, TokenBucket> probes{}; ///< to others
        std::map<ParticipantId, TokenBucket> answers{};
    };

    void tellParticipants(LocalTime now);
    /// The strategy goes on with the host's objects.
    void goOn(SessionTime session, LocalTime now);
    /// Forwards a message with an action, now or with others.
    void relay(Peer& peer, ObjectId object, const std::vector<std::byte>& message, LocalTime now);
    /// Whether a message with an action on this object is not put off.
    [[nodiscard]] static bool isRelayedAtOnce(Peer& peer, ObjectId object, LocalTime now);
    void relayDue(LocalTime now);
    [[nodiscard]] bool hasLag() const { return m_choice.kind == StrategyKind::LocalLag; }
    /// The lag with which actions of this peer, or nullptr for the host, begin everywhere at once.
    [[nodiscard]] Duration lagOf(const Peer* author) const;
    /// @param due when it is to be forwarded if it is new
    EventTable::Verdict spread(ParticipantId from, const EventCpo& event, SessionTime session,
                               LocalTime now, LocalTime due);

    SharedActions m_actions;
    StrategyHost m_strategy;
    StrategyChoice m_choice;
    Duration m_longestWait{};
    EventRepeater m_own{true};
    std::vector<EventCpo> m_handedOver; // continued or restored, not forwarded yet
    std::set<ObjectId> m_changed;
    std::map<PeerAddress, Peer> m_peers;
};

} // namespace carina
