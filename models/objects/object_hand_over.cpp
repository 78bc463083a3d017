#include "models/objects/object_hand_over.h"

#include "engine/session/object_rules.h"
#include "models/errors/error_text.h"
#include "models/objects/object_words.h"
#include "models/session/propose_back.h"

namespace carina
{
namespace
{

/// Why an object that somebody got since does not go back; empty where nobody did.
/// @param from whom it belonged to before @param to who got it then
QString decidedSince(const SessionState& state, const SharedObject& object, ParticipantId from,
                     ParticipantId to)
{
    if (object.owner == to)
        return {};
    const QString what = objectWord(object);
    if (object.owner == kNobody)
        return from == kNobody
                   ? ObjectHandOver::tr("Nothing to undo: somebody has put %1 back.").arg(what)
                   : ObjectHandOver::tr("Not undone: somebody has put %1 back since.").arg(what);
    const QString who = participantWord(state, object.owner);
    return object.owner == from
               ? ObjectHandOver::tr("Nothing to undo: %2 has got %1 back.").arg(what, who)
               : ObjectHandOver::tr("Not undone: %2 has got %1 since.").arg(what, who);
}

/// Why an object cannot go back to a participant, wherever it is; empty where it can.
QString faultOfOwner(const SessionState& state, const SharedObject& object, ParticipantId owner)
{
    if (owner == kNobody)
        return {};
    const QString what = objectWord(object);
    const QString who = participantWord(state, owner);
    const auto found = state.participants().find(owner);
    if (found == state.participants().end() || !found->second.present)
        return ObjectHandOver::tr("Not undone: %2, to whom %1 belonged, has left the session.")
            .arg(what, who);
    if (found->second.role == Role::Trainee && found->second.station != object.station)
        return ObjectHandOver::tr("Not undone: %2, to whom %1 belonged, is at another station now.")
            .arg(what, who);
    return {};
}

/// What the host would say at present if `author` gave the object to another owner.
QString refusalOf(const SessionState& state, ParticipantId author, const SharedObject& object,
                  ParticipantId owner)
{
    const auto may = checkHandOver(state, author, {object.id, owner, object.epoch});
    if (may)
        return {};
    if (may.error().code == Errc::NotPermitted)
        return ObjectHandOver::tr(
                   "Not undone: %2, to whom %1 belonged, has as much as they may hold.")
            .arg(objectWord(object), participantWord(state, owner));
    return errorText(may.error());
}

} // namespace

void ObjectHandOver::pass(const SharedObject& object, ParticipantId to)
{
    if (m_history)
        m_history->add(
            m_owner, textOf(object, to),
            [this, id = object.id, from = object.owner, to] { takeBack(id, from, to); },
            object.id.value, object.station);
    m_node.propose(object.station, fact::ObjectHandedOver{object.id, to, object.epoch});
}

QString ObjectHandOver::textOf(const SharedObject& object, ParticipantId to) const
{
    const auto state = m_node.state();
    const QString what = objectWord(object);
    if (to == kNobody)
        return tr("%1 → put back").arg(what);
    if (object.owner == kNobody)
        return tr("%1 → lifted out").arg(what);
    if (to == m_node.self())
        return tr("%1 → taken over from %2").arg(what, participantWord(*state, object.owner));
    return tr("%1 → given to %2").arg(what, participantWord(*state, to));
}

/// As it will be once what is under way from here has arrived.
SharedObject ObjectHandOver::prospectOf(const SharedObject& object) const
{
    SharedObject later = object;
    for (const FactBody& body : m_node.pending()) {
        const auto* handed = std::get_if<fact::ObjectHandedOver>(&body);
        if (!handed || handed->object != later.id || handed->epoch != later.epoch)
            continue;
        later.owner = handed->owner;
        ++later.epoch;
    }
    return later;
}

void ObjectHandOver::takeBack(ObjectId id, ParticipantId from, ParticipantId to)
{
    const auto state = m_node.state();
    const auto found = state->objects().find(id);
    if (found == state->objects().end())
        return;
    const SharedObject object = prospectOf(found->second);
    const bool isUnderWay = object.epoch != found->second.epoch; // the host judges it by then
    QString why = decidedSince(*state, object, from, to);
    if (why.isEmpty())
        why = faultOfOwner(*state, object, from);
    if (why.isEmpty() && !isUnderWay)
        why = refusalOf(*state, m_node.self(), object, from);
    proposeBack(m_node, object.station, fact::ObjectHandedOver{id, from, object.epoch}, why,
                m_history);
}

} // namespace carina
