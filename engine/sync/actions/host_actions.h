#pragma once

#include "engine/sync/actions/shared_actions.h"

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

    void join(PeerAddress address, ParticipantId participant, LocalTime now);
    void leave(PeerAddress address) { m_peers.erase(address); }

    /// Sets the ownership of an object, taken from the facts. Where the owner changed, the action
    /// in force continues under the new ownership (SharedActions::continued).
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
    void acknowledge(PeerAddress from, const EventAck& ack);
    /// Restores an action that was in force before a restart of the host; it continues under the
    /// present ownership. Ignored for an object that is not shared.
    void restore(const EventCpo& event);
    /// The newest action of every object on which it changed since the last call: to be stored, and
    /// given to restore() after a restart.
    [[nodiscard]] std::vector<EventCpo> takeChanged();

    /// Forwards the host's own actions and heartbeats; to be called before takeDue.
    void advance(SessionTime session, LocalTime now);
    /// Acknowledgements and actions to send to a peer now; they count as sent.
    [[nodiscard]] std::vector<WireRecord> takeDue(PeerAddress to, LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

    [[nodiscard]] const SharedActions& shared() const { return m_actions; }

private:
    struct Peer {
        ParticipantId participant;
        EventRepeater events{false};
        std::vector<WireRecord> acks{};
    };

    EventTable::Verdict spread(ParticipantId from, const EventCpo& event, SessionTime session,
                               LocalTime now);

    SharedActions m_actions;
    EventRepeater m_own{true};
    std::vector<EventCpo> m_handedOver; // continued or restored, not forwarded yet
    std::set<ObjectId> m_changed;
    std::map<PeerAddress, Peer> m_peers;
};

} // namespace carina
