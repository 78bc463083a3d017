#pragma once

#include "engine/sync/actions/shared_actions.h"
#include "engine/sync/strategies/strategy_end.h"

namespace carina
{

/// A participant's end of actions on shared objects: begins actions on its own objects, sends them
/// until the host acknowledges them, and stores those that the host forwards. Where the session has
/// a relayed strategy, that decides what is shown from the next action on an object on.
class ClientActions
{
public:
    void setSelf(ParticipantId self) { m_actions.setSelf(self); }
    /// The session's strategy, taken from the facts. It goes on with own objects as they are at
    /// this session time, where that is known, so that it need not wait for an action.
    void setStrategy(const StrategyChoice& choice, LocalTime now,
                     std::optional<SessionTime> session = std::nullopt);
    /// The other participants who are present.
    void setOthers(std::vector<ParticipantId> others, LocalTime now);
    /// The lag with which own actions begin everywhere at once, as the host told.
    void setNeededLag(Duration lag) { m_neededLag = lag; }
    /// Forgets everything: the host has another session.
    void startAfresh();
    /// The connection ended. Pending acknowledgements are dropped, and own actions are sent whole
    /// again on the next connection, because a restarted host may have lost what it had
    /// acknowledged. What the strategy's messages brought is forgotten, because later ones may be
    /// missed.
    void disconnected(LocalTime now);
    /// There is a connection again. What the strategy had to send meanwhile is dropped; it goes on
    /// with own objects as they are at this session time, where that is known.
    void connected(std::optional<SessionTime> session, LocalTime now);

    /// Sets the ownership of an object, taken from the facts.
    void share(ObjectId object, const Ownership& ownership);
    /// Begins an action on an object of this participant. @returns what SharedActions::begun does.
    [[nodiscard]] Result<void> act(ObjectId object, const ObjectAction& action, SessionTime session,
                                   LocalTime now);
    /// A message of the strategy that the host forwarded: dropped where it is an action on an
    /// object by another than its present owner, as known here.
    void take(const StrategyMessage& message, LocalTime now);
    /// An action that the host forwarded. @param session present session time, where it is known
    void take(const EventCpo& event, std::optional<SessionTime> session, LocalTime now);
    /// A heartbeat that the host forwarded: counts as a repeat of the action it names where that is
    /// the newest here, and is ignored otherwise.
    void take(const EventBeat& beat, std::optional<SessionTime> session, LocalTime now);
    void acknowledge(const EventAck& ack) { m_repeater.acknowledge(ack); }

    /// Acknowledgements and actions to send to the host now; they count as sent.
    [[nodiscard]] std::vector<WireRecord> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;

    [[nodiscard]] const SharedActions& shared() const { return m_actions; }
    /// How the strategy itself probes the path to another participant (StarParticipant::triggerTo).
    [[nodiscard]] const ProbeTrigger* triggerTo(ParticipantId other) const
    {
        return m_strategy.triggerTo(other);
    }

private:
    void beginStrategy(LocalTime now);
    void goOn(std::optional<SessionTime> session, LocalTime now);
    void goOn(const EventCpo& event, std::optional<SessionTime> session, LocalTime now);

    SharedActions m_actions;
    StrategyChoice m_choice;
    std::vector<ParticipantId> m_others;
    StrategyEnd m_strategy;
    Duration m_neededLag{};
    EventRepeater m_repeater{true}; // for objects of this participant
    // newly owned objects, whose action is still to be given to m_repeater
    std::vector<ObjectId> m_adopted;
    std::vector<WireRecord> m_acks;
};

} // namespace carina
