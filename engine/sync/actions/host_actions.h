#pragma once

#include "engine/sync/actions/shared_actions.h"

#include <map>
#include <set>

namespace carina
{

/// Where a datagram comes from or goes to; only the socket's owner knows what it stands for.
using PeerAddress = std::uint64_t;

/// The session host's part in actions on shared objects: takes those of their owners, its own
/// included, passes each on to everybody else until it is acknowledged, and brings late joiners the
/// newest of every object.
class HostActions
{
public:
    HostActions() { m_actions.setSelf(ParticipantId{0}); }

    void join(PeerAddress address, ParticipantId participant, LocalTime now);
    void leave(PeerAddress address) { m_peers.erase(address); }

    /// As the facts say. With another owner the action in force goes on in that one's name
    /// (SharedActions::continued).
    void share(ObjectId object, const Ownership& ownership);
    /// Takes an action on an object of the host's own. @returns what SharedActions::begun does.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, SessionTime session,
                                   LocalTime now);
    /// An action that came from a peer: acknowledged and passed on where it is the owner's, under
    /// the present ownership; dropped otherwise.
    void take(PeerAddress from, const EventCpo& event, SessionTime session, LocalTime now);
    /// A sign of life: as if the action it names had come again, if that is the newest here.
    void take(PeerAddress from, const EventBeat& beat, SessionTime session, LocalTime now);
    void acknowledge(PeerAddress from, const EventAck& ack);
    /// An action that was in force before the host was started: goes on, in the name of whoever
    /// owns the object by now. Nothing for an object that is not shared.
    void restore(const EventCpo& event);
    /// The newest action of every object on which it is another than at the last call: what a host
    /// that is started again is to be told by restore().
    [[nodiscard]] std::vector<EventCpo> takeChanged();

    /// Passes on what the host itself has to say; called before takeDue.
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
    std::vector<EventCpo> m_handedOver; // to be passed on
    std::set<ObjectId> m_changed;
    std::map<PeerAddress, Peer> m_peers;
};

} // namespace carina
