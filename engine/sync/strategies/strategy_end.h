#pragma once

#include "engine/sync/strategies/relayed_view.h"
#include "engine/sync/strategies/strategy.h"

#include <algorithm>
#include <map>

namespace carina
{

/// A program's end of its session's strategy, where that is a relayed one. With the others nothing
/// is sent or shown here: their actions go by the session clock (ClientActions, HostActions).
class StrategyEnd
{
public:
    /// Begins anew with this strategy; what was shown is forgotten.
    void choose(const StrategyChoice& choice, const StarSeat& seat, LocalTime now);
    void setOthers(std::span<const ParticipantId> others, LocalTime now);

    /// An own action begins.
    void begin(const EventCpo& action, LocalTime now);
    void forget(ObjectId object);
    /// A message that the host forwarded.
    void receive(std::span<const std::byte> bytes, LocalTime now);

    /// Messages to send to the host now; they count as sent.
    [[nodiscard]] std::vector<std::vector<std::byte>> takeDue(LocalTime now);
    [[nodiscard]] LocalTime nextDue() const;
    /// What is shown; nullptr where the session clock decides it.
    [[nodiscard]] const RelayedView* view() const;
    /// As StarParticipant::triggerTo; nullptr where the session clock decides what is shown.
    [[nodiscard]] const ProbeTrigger* triggerTo(ParticipantId other) const;

private:
    std::unique_ptr<StarParticipant> m_participant;
};

/// The host's end of its session's strategy: forwards the messages of the participants, of whom the
/// host is one.
class StrategyHost
{
public:
    void choose(const StrategyChoice& choice, LocalTime now);
    /// Who is present, the host included.
    void setParticipants(std::vector<ParticipantId> participants, LocalTime now);

    /// Whether messages to this participant are forwarded.
    [[nodiscard]] bool isPresent(ParticipantId participant) const
    {
        return m_relay && std::ranges::find(m_participants, participant) != m_participants.end();
    }

    /// An action of the host begins.
    void begin(const EventCpo& action, LocalTime now);
    void forget(ObjectId object) { m_own.forget(object); }
    /// @pre a participant may act on the object of an action in it (see relayed_message.h).
    void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now);

    /// Lets the host's own end send; to be called before takeDue.
    void advance(LocalTime now);
    [[nodiscard]] std::vector<std::vector<std::byte>> takeDue(ParticipantId to);
    [[nodiscard]] LocalTime nextDue() const;
    [[nodiscard]] const RelayedView* view() const { return m_own.view(); }
    /// Of the host's own end.
    [[nodiscard]] const ProbeTrigger* triggerTo(ParticipantId other) const
    {
        return m_own.triggerTo(other);
    }

private:
    void forward(LocalTime now);

    std::vector<ParticipantId> m_participants;
    StrategyEnd m_own;
    // Neither where the session clock decides what is shown.
    const SyncStrategy* m_relayed = nullptr;
    std::unique_ptr<StarNode> m_relay; // its end at the host; made anew when somebody comes or goes
    std::map<ParticipantId, std::vector<std::vector<std::byte>>> m_outgoing;
};

} // namespace carina
