#include "models/objects/shared_object_model.h"

#include "engine/session/participant_limits.h"
#include "models/objects/object_words.h"

#include <algorithm>
#include <ranges>

namespace carina
{
namespace
{

bool isPresent(const SessionState& state, ParticipantId id)
{
    const auto found = state.participants().find(id);
    return found != state.participants().end() && found->second.present;
}

bool hasFallenSilent(const SessionState& state, ParticipantId id)
{
    const auto found = state.participants().find(id);
    return found != state.participants().end() && found->second.fellSilent;
}

} // namespace

SharedObjectModel::SharedObjectModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_station{station}, m_handOver{*this, session.node()}
{
    connect(&m_session, &SessionModel::changed, this, &SharedObjectModel::changed);
}

void SharedObjectModel::setStation(StationId station)
{
    if (std::exchange(m_station, station) != station)
        Q_EMIT changed();
}

std::vector<SharedObjectModel::Named<ObjectId>> SharedObjectModel::objects() const
{
    std::vector<Named<ObjectId>> all;
    const auto state = m_session.node().state();
    for (const auto& [id, object] : state->objects())
        if (isOffered(object))
            all.push_back({id, objectWord(object)});
    return all;
}

bool SharedObjectModel::isOffered(const SharedObject& object) const
{
    if (object.station != m_station || !isActedOn(object.kind))
        return false;
    const auto group =
        object.kind == ObjectKind::OrganGroup ? groupFromName(object.name) : std::nullopt;
    return !group || std::ranges::find(m_groups, *group) != m_groups.end();
}

void SharedObjectModel::setGroups(std::vector<OrganGroup> groups)
{
    if (std::exchange(m_groups, std::move(groups)) != m_groups)
        Q_EMIT changed();
}

std::optional<SharedObject> SharedObjectModel::chosen() const
{
    const auto all = objects();
    if (all.empty())
        return std::nullopt;
    const auto wanted =
        std::ranges::find_if(all, [this](const auto& o) { return o.id == m_wanted; });
    const ObjectId id = wanted == all.end() ? all.front().id : wanted->id;
    return m_session.node().state()->objects().at(id);
}

void SharedObjectModel::choose(ObjectId object)
{
    m_wanted = object;
    Q_EMIT changed();
}

const Participant* SharedObjectModel::self(const SessionState& state) const
{
    const auto found = state.participants().find(m_session.node().self());
    return found == state.participants().end() ? nullptr : &found->second;
}

QString SharedObjectModel::obstacle() const
{
    const auto state = m_session.node().state();
    const Participant* person = self(*state);
    if (!person)
        return tr("Wait until the session has admitted you.");
    if (person->role == Role::Observer)
        return tr("Observers cannot move anything. Ask the instructor to admit you as a trainee if "
                  "you want to.");
    if (person->muted)
        return tr("An instructor has muted you. You can move things again when that is taken "
                  "back.");
    if (!chosen())
        return tr("No object that can be moved is shared yet. The instructor's console shares the "
                  "virtual patient.");
    return {};
}

bool SharedObjectModel::isInstructor() const
{
    const auto state = m_session.node().state();
    const Participant* person = self(*state);
    return person && person->role == Role::Instructor;
}

bool SharedObjectModel::isOwn() const
{
    const auto object = chosen();
    return object && object->owner == m_session.node().self();
}

QString SharedObjectModel::ownerText() const
{
    const auto object = chosen();
    if (!object)
        return {};
    const auto state = m_session.node().state();
    const QString owner = participantWord(*state, object->owner);
    QString text = object->owner == kNobody                 ? tr("○ nobody: in its place")
                   : isOwn()                                ? tr("● you")
                   : isPresent(*state, object->owner)       ? tr("◆ %1").arg(owner)
                   : hasFallenSilent(*state, object->owner) ? tr("▲ %1, is away").arg(owner)
                                                            : tr("○ %1, has left").arg(owner);
    const auto travelling = underWay(object->id);
    if (const auto* handed =
            travelling ? std::get_if<fact::ObjectHandedOver>(&*travelling) : nullptr)
        text += tr(" → %1").arg(handed->owner == kNobody ? tr("back to its place")
                                                         : participantWord(*state, handed->owner));
    return text;
}

QString SharedObjectModel::wishText() const
{
    const auto object = chosen();
    if (!object)
        return {};
    const auto state = m_session.node().state();
    if (const QString full = handsFull(*object); !full.isEmpty())
        return full;
    QStringList names;
    for (const ParticipantId id : object->wantedBy)
        names << (id == m_session.node().self() ? tr("you") : participantWord(*state, id));
    return names.isEmpty() ? QString{} : tr("Asking for it: %1").arg(names.join(tr(", ")));
}

std::optional<FactBody> SharedObjectModel::underWay(ObjectId object) const
{
    for (const FactBody& body : m_session.node().pending()) {
        const auto* wanted = std::get_if<fact::ObjectWanted>(&body);
        if (objectOf(body) == object || (wanted && wanted->object == object))
            return body;
    }
    return std::nullopt;
}

bool SharedObjectModel::isAsking() const
{
    const auto object = chosen();
    return object
           && std::ranges::find(object->wantedBy, m_session.node().self())
                  != object->wantedBy.end();
}

bool SharedObjectModel::canAsk() const
{
    const auto object = chosen();
    return object && obstacle().isEmpty() && !isOwn() && object->owner != kNobody
           && !underWay(object->id);
}

void SharedObjectModel::ask()
{
    if (canAsk())
        m_session.node().propose(m_station, fact::ObjectWanted{chosen()->id, !isAsking()});
}

bool SharedObjectModel::mayGive(const SharedObject& object) const
{
    const auto state = m_session.node().state();
    const Participant* person = self(*state);
    return person && person->role != Role::Observer && !underWay(object.id)
           && (person->role == Role::Instructor || object.owner == person->id);
}

bool SharedObjectModel::canTakeOver() const
{
    const auto object = chosen();
    return object && !isOwn() && object->owner != kNobody && mayGive(*object);
}

void SharedObjectModel::takeOver()
{
    if (canTakeOver())
        handOver(m_session.node().self());
}

bool SharedObjectModel::isLiftable() const
{
    const auto object = chosen();
    return object && carina::isLiftable(object->kind);
}

/// That a trainee holds as many groups as they may; empty where this does not matter.
QString SharedObjectModel::handsFull(const SharedObject& object) const
{
    const auto state = m_session.node().state();
    const Participant* person = self(*state);
    if (!person || person->role != Role::Trainee || object.kind != ObjectKind::OrganGroup
        || object.owner != kNobody)
        return {};
    const auto held = std::ranges::count_if(state->objects(), [person](const auto& entry) {
        return entry.second.owner == person->id && entry.second.kind == ObjectKind::OrganGroup;
    });
    return std::size_t(held) < kMostGroupsHeld
               ? QString{}
               : tr("You hold %1 groups of organs, as many as you may. Put one back first.")
                     .arg(held);
}

bool SharedObjectModel::canLift() const
{
    const auto object = chosen();
    return object && isLiftable() && object->owner == kNobody && obstacle().isEmpty()
           && !underWay(object->id) && handsFull(*object).isEmpty();
}

void SharedObjectModel::lift()
{
    if (canLift())
        take(*chosen());
}

bool SharedObjectModel::canPutBack() const
{
    const auto object = chosen();
    return object && mayPutBack(*object);
}

bool SharedObjectModel::mayPutBack(const SharedObject& object) const
{
    return carina::isLiftable(object.kind) && object.owner != kNobody && obstacle().isEmpty()
           && mayGive(object);
}

void SharedObjectModel::putBack(ObjectId object)
{
    const auto state = m_session.node().state();
    const auto found = state->objects().find(object);
    if (found == state->objects().end() || !mayPutBack(found->second))
        return;
    const SharedObject& put = found->second;
    if (put.owner == m_session.node().self()) // who moves it brings it back to where it was
        m_session.node().propose(put.station, fact::ObjectHandedOver{object, kNobody, put.epoch});
    else
        m_handOver.pass(put, kNobody);
}

std::vector<ObjectId> SharedObjectModel::toPutBack() const
{
    const auto state = m_session.node().state();
    std::vector<ObjectId> all;
    for (const auto& [id, object] : state->objects())
        if (object.station == m_station && mayPutBack(object))
            all.push_back(id);
    return all;
}

void SharedObjectModel::take(const SharedObject& object)
{
    m_handOver.pass(object, m_session.node().self());
}

std::vector<SharedObjectModel::Named<ParticipantId>> SharedObjectModel::heirs() const
{
    const auto object = chosen();
    if (!object || object->owner == kNobody || !mayGive(*object))
        return {};
    const auto state = m_session.node().state();
    const auto mayGetIt = [&](ParticipantId id, const Participant& person) {
        const bool asks = std::ranges::find(object->wantedBy, id) != object->wantedBy.end();
        return person.role == Role::Instructor
               || (person.role == Role::Trainee && person.station == m_station
                   && (asks || isInstructor()));
    };
    std::vector<Named<ParticipantId>> all;
    for (const auto& [id, person] : state->participants())
        if (person.present && id != object->owner && id != m_session.node().self()
            && mayGetIt(id, person))
            all.push_back({id, QString::fromStdString(person.name)});
    const auto turn = [&object](const Named<ParticipantId>& heir) {
        return std::ranges::find(object->wantedBy, heir.id) - object->wantedBy.begin();
    };
    std::ranges::stable_sort(all, {}, turn);
    return all;
}

void SharedObjectModel::handOver(ParticipantId heir)
{
    if (const auto object = chosen(); object && mayGive(*object))
        m_handOver.pass(*object, heir);
}

} // namespace carina
