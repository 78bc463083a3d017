#pragma once

#include "engine/sync/strategies/relayed_message.h"
#include "engine/sync/strategies/relayed_view.h"
#include "engine/sync/strategies/strategy.h"

namespace carina
{

/// Common base of the strategies over a RelayHost: an own action starts here at once and is sent to
/// all others once; a derived class starts an action that arrives.
class RelayedParticipant : public StarParticipant
{
public:
    explicit RelayedParticipant(ParticipantId self) : m_self{self} {}

    void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) override;
    void advance(LocalTime) override {}
    void act(const EventCpo& action, LocalTime now) override;
    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, LocalTime t) const override;
    [[nodiscard]] const RelayedView* view() const override { return &m_view; }
    void forget(ObjectId object) override { m_view.forget(object); }

protected:
    /// An action of another participant has arrived.
    virtual void actionReceived(const EventCpo& action, ParticipantId from, LocalTime now) = 0;
    virtual void probeReceived(const DelayProbe&, ParticipantId, LocalTime) {}
    virtual void answerReceived(const DelayAnswer&, ParticipantId, LocalTime) {}

    void sendRelayed(ParticipantId to,
                     const std::variant<EventCpo, DelayProbe, DelayAnswer>& content);
    [[nodiscard]] ParticipantId self() const { return m_self; }
    [[nodiscard]] RelayedView& drawn() { return m_view; }

private:
    struct Visitor;

    ParticipantId m_self;
    RelayedView m_view;
};

/// Start time of an action on this participant's own clock, for strategies without a session clock.
[[nodiscard]] inline SessionTime ownStamp(LocalTime now)
{
    return SessionTime{now.time_since_epoch()};
}

} // namespace carina
