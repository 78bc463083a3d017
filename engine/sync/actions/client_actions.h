#pragma once

#include "engine/sync/actions/shared_actions.h"

namespace carina
{

/// A participant's part in actions on shared objects: takes its own and sends them until the host
/// has them, and takes what the host passes on.
class ClientActions
{
public:
    void setSelf(ParticipantId self) { m_actions.setSelf(self); }
    /// It is another session.
    void startAfresh();
    /// What the old connection brought is acknowledged no more, and a host that was restarted may
    /// not have all that the last one acknowledged.
    void disconnected();

    /// As the facts say.
    void share(ObjectId object, const Ownership& ownership);
    /// Takes an action on an object of its own. @returns what SharedActions::begun does.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, SessionTime session,
                                   LocalTime now);
    /// An action that the host passed on. @param session the session's time, where it is known
    void take(const EventCpo& event, std::optional<SessionTime> session, LocalTime now);
    /// A sign of life that the host passed on: as if the action it names had come again, if that is
    /// the newest here.
    void take(const EventBeat& beat, std::optional<SessionTime> session, LocalTime now);
    void acknowledge(const EventAck& ack) { m_repeater.acknowledge(ack); }

    /// Acknowledgements and actions to send to the host now; they count as sent.
    [[nodiscard]] std::vector<WireRecord> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

    [[nodiscard]] const SharedActions& shared() const { return m_actions; }

private:
    SharedActions m_actions;
    EventRepeater m_repeater{true};  // of the objects of its own
    std::vector<ObjectId> m_adopted; // have become its own; their repeating is to begin
    std::vector<WireRecord> m_acks;
};

} // namespace carina
