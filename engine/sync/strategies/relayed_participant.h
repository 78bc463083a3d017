#pragma once

#include "engine/sync/strategies/relayed_message.h"
#include "engine/sync/strategies/strategy.h"

#include <unordered_map>

namespace carina
{

/// The actions in force at this participant, each begun at its own local time.
class RunningActions
{
public:
    void begin(const EventCpo& action, LocalTime start)
    {
        m_running[action.object] = {action, start};
    }
    [[nodiscard]] std::optional<ActedPose> at(ObjectId object, LocalTime t) const;

private:
    struct Running {
        EventCpo action;
        LocalTime start;
    };
    std::unordered_map<ObjectId, Running> m_running;
};

/// Common base of the strategies over a RelayHost: an own action starts here at once and is sent to
/// all others once; a derived class starts an action that arrives.
class RelayedParticipant : public StarParticipant
{
public:
    explicit RelayedParticipant(const StarSeat& seat) : m_seat{seat} {}

    void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) override;
    void advance(LocalTime) override {}
    void act(const EventCpo& action, LocalTime now) override;
    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, LocalTime t) const override;

protected:
    /// An action of another participant has arrived.
    virtual void actionReceived(const EventCpo& action, ParticipantId from, LocalTime now) = 0;
    virtual void probeReceived(const DelayProbe&, ParticipantId, LocalTime) {}
    virtual void answerReceived(const DelayAnswer&, ParticipantId, LocalTime) {}

    void sendRelayed(ParticipantId to,
                     const std::variant<EventCpo, DelayProbe, DelayAnswer>& content);
    [[nodiscard]] const StarSeat& seat() const { return m_seat; }
    [[nodiscard]] RunningActions& running() { return m_running; }
    [[nodiscard]] const RunningActions& running() const { return m_running; }

private:
    struct Visitor;

    StarSeat m_seat;
    RunningActions m_running;
};

/// Start time of an action on this participant's own clock, for strategies without a session clock.
[[nodiscard]] inline SessionTime ownStamp(LocalTime now)
{
    return SessionTime{now.time_since_epoch()};
}

} // namespace carina
