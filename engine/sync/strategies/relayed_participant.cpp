#include "engine/sync/strategies/relayed_participant.h"

namespace carina
{

struct RelayedParticipant::Visitor {
    RelayedParticipant& participant;
    ParticipantId from;
    LocalTime now;

    void operator()(const EventCpo& action) { participant.actionReceived(action, from, now); }
    void operator()(const DelayProbe& probe) { participant.probeReceived(probe, from, now); }
    void operator()(const DelayAnswer& answer) { participant.answerReceived(answer, from, now); }
};

void RelayedParticipant::receive(ParticipantId, std::span<const std::byte> bytes, LocalTime now)
{
    const auto message = decodeRelayed(bytes);
    if (!message || (message->to != m_self && message->to != kAllOthers))
        return;
    std::visit(Visitor{*this, message->from, now}, message->content);
}

void RelayedParticipant::act(const EventCpo& action, LocalTime now)
{
    m_view.begin(action, now);
    EventCpo stamped = action;
    stamped.start = ownStamp(now);
    sendRelayed(kAllOthers, stamped);
}

std::optional<ShownObject> RelayedParticipant::shown(ObjectId object, LocalTime t) const
{
    const auto acted = m_view.at(object, t);
    if (!acted)
        return std::nullopt;
    ShownObject shown{*acted};
    if (const EventCpo* action = m_view.running(object)) {
        shown.kind = action->kind;
        shown.axis_A = action->axis_A.cast<double>();
        shown.rate = double{action->rate};
    }
    return shown;
}

void RelayedParticipant::sendRelayed(ParticipantId to,
                                     const std::variant<EventCpo, DelayProbe, DelayAnswer>& content)
{
    send(kStarHost, encodeRelayed({m_self, to, content}));
}

} // namespace carina
