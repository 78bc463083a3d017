#include "models/session/people_model.h"

#include "engine/session/people_rules.h"
#include "models/objects/object_words.h"
#include "models/session/propose_back.h"
#include "models/session/proposed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace carina
{
namespace
{

constexpr double kQuarter = 0.5 * std::numbers::pi;
constexpr int kQuarters = 4;

const SharedObject* headOwnedBy(const SessionState& state, ParticipantId owner, StationId station)
{
    const auto found = std::ranges::find_if(state.objects(), [&](const auto& entry) {
        const SharedObject& object = entry.second;
        return object.owner == owner && object.station == station
               && object.kind == ObjectKind::Head;
    });
    return found == state.objects().end() ? nullptr : &found->second;
}

/// In quarter turns about +y of A from the patient's head.
int sideOf(const std::optional<RigidTransform>& X_AH)
{
    if (!X_AH)
        return 0;
    const Vec3& p = X_AH->translation();
    return static_cast<int>(std::lround(std::atan2(p.x(), p.z()) / kQuarter));
}

QString placedText(const QString& who, std::optional<PatientSide> side)
{
    if (!side)
        return PeopleModel::tr("%1 → seen as tracked").arg(who);
    switch (*side) {
    case PatientSide::Head:
        return PeopleModel::tr("%1 → seen at the patient's head").arg(who);
    case PatientSide::Left:
        return PeopleModel::tr("%1 → seen at the patient's left").arg(who);
    case PatientSide::Feet:
        return PeopleModel::tr("%1 → seen at the patient's feet").arg(who);
    case PatientSide::Right:
        return PeopleModel::tr("%1 → seen at the patient's right").arg(who);
    }
    return {};
}

} // namespace

Angle turnTo(PatientSide side, const std::optional<RigidTransform>& X_AH)
{
    const int quarters = (static_cast<int>(side) - sideOf(X_AH) + 2 * kQuarters) % kQuarters;
    return radians(kQuarter * (quarters > 2 ? quarters - kQuarters : quarters));
}

PeopleModel::PeopleModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_station{station}
{
    connect(&m_session, &SessionModel::changed, this, &PeopleModel::changed);
}

void PeopleModel::setStation(StationId station)
{
    if (std::exchange(m_station, station) != station)
        Q_EMIT changed();
}

PeopleModel::Person PeopleModel::personOf(const SessionState& state, const Participant& who) const
{
    const ParticipantId self = m_session.node().self();
    const auto own = state.participants().find(self);
    const Role role = own == state.participants().end() ? Role::Observer : own->second.role;
    const ParticipantId worker = state.atWork(m_station);
    Person person{.id = who.id, .name = QString::fromStdString(who.name)};
    person.isSelf = who.id == self;
    person.isAtWork = who.id == worker;
    person.hasHead = headOwnedBy(state, who.id, m_station) != nullptr;
    const bool mayGive =
        role == Role::Instructor
        || (role == Role::Trainee && (worker == self || (worker == kNobody && person.isSelf)));
    person.canBeGiven = mayGive && !person.isAtWork && who.role != Role::Observer;
    person.canBePlaced =
        person.hasHead && (role == Role::Instructor || (role == Role::Trainee && person.isSelf));
    person.isPlaced = who.turn != Angle{};
    return person;
}

std::vector<PeopleModel::Person> PeopleModel::people() const
{
    const auto state = m_session.node().state();
    std::vector<Person> people;
    for (const auto& [id, who] : state->participants())
        if (who.present && who.station == m_station)
            people.push_back(personOf(*state, who));
    return people;
}

std::optional<PeopleModel::Person> PeopleModel::person(ParticipantId id) const
{
    const std::vector<Person> all = people();
    const auto found = std::ranges::find(all, id, &Person::id);
    return found == all.end() ? std::nullopt : std::optional{*found};
}

QString PeopleModel::whyNotHere(ParticipantId id) const
{
    const auto state = m_session.node().state();
    const QString name = participantWord(*state, id);
    return state->isPresent(id) ? tr("%1 is at another station.").arg(name)
                                : tr("%1 is not here any more.").arg(name);
}

QString PeopleModel::obstacleToWork(ParticipantId id) const
{
    const auto who = person(id);
    if (!who)
        return whyNotHere(id);
    if (who->canBeGiven)
        return {};
    if (who->isAtWork)
        return tr("%1 is at work already.").arg(who->name);
    return m_session.node().state()->participants().at(id).role == Role::Observer
               ? tr("%1 is an observer, who is not given work.").arg(who->name)
               : tr("Only an instructor, or who is at work, can give work to %1.").arg(who->name);
}

QString PeopleModel::obstacleToPlace(ParticipantId id) const
{
    const auto who = person(id);
    if (!who)
        return whyNotHere(id);
    if (who->canBePlaced)
        return {};
    return who->hasHead ? tr("Only an instructor, or they themselves, can place %1.").arg(who->name)
                        : tr("%1 shares no head that could be placed.").arg(who->name);
}

QString PeopleModel::workText() const
{
    for (const Person& person : people())
        if (person.isAtWork)
            return person.isSelf ? tr("● You are at work") : tr("● At work: %1").arg(person.name);
    return tr("○ Nobody is at work");
}

void PeopleModel::giveWork(ParticipantId to)
{
    SessionNode& node = m_session.node();
    const auto state = node.state();
    const ParticipantId before = state->atWork(m_station);
    if (m_history && before != kNobody && before != to)
        m_history->add(
            *this, tr("Work → %1", "a participant").arg(participantWord(*state, to)),
            [this, station = m_station, before, to] { takeBackWork(station, before, to); }, 0,
            m_station);
    node.propose(m_station, fact::WorkTaken{to, before});
}

/// What is under way is judged by the host before what takes it back.
void PeopleModel::takeBackWork(StationId station, ParticipantId before, ParticipantId given)
{
    SessionNode& node = m_session.node();
    const bool isUnderWay = isProposed<fact::WorkTaken>(
        node, [given](const fact::WorkTaken& proposed) { return proposed.participant == given; });
    const fact::WorkTaken back{before, isUnderWay ? given : node.state()->atWork(station)};
    proposeBack(node, station, back, isUnderWay ? QString{} : whyWorkStays(station, back, given),
                m_history);
}

/// Empty where it can be taken back, also from who has left since.
QString PeopleModel::whyWorkStays(StationId station, const fact::WorkTaken& back,
                                  ParticipantId given) const
{
    const auto state = m_session.node().state();
    const QString who = participantWord(*state, back.participant);
    if (back.before == back.participant)
        return tr("Nothing to undo: %1 is at work again.").arg(who);
    if (back.before != given && back.before != kNobody)
        return tr("Not undone: %1 is at work now.").arg(participantWord(*state, back.before));
    return checkPeople(*state, station, back)
               ? QString{}
               : tr("Not undone: %1, who was at work, is not at the station any more.").arg(who);
}

void PeopleModel::place(ParticipantId id, std::optional<PatientSide> side,
                        const std::optional<PoseSample>& ownHead)
{
    SessionNode& node = m_session.node();
    const auto state = node.state();
    const SharedObject* head = headOwnedBy(*state, id, m_station);
    std::optional<PoseSample> seen = id == node.self() ? ownHead : std::nullopt;
    if (const auto poses = head ? node.object(head->id) : nullptr)
        seen = poses->newest();
    const auto X_AH = seen ? std::optional{seen->X_FO} : std::nullopt;
    const Angle turn = side ? turnTo(*side, X_AH) : Angle{};
    const auto known = state->participants().find(id);
    if (known == state->participants().end() || known->second.turn == turn)
        return;
    const fact::PlaceChosen chosen{id, turn};
    const fact::PlaceChosen before{id, known->second.turn};
    if (m_history)
        m_history->add(*this, placedText(participantWord(*state, id), side),
                       [this, before, chosen] { takeBackPlace(before, chosen); });
    node.propose(m_station, chosen);
}

void PeopleModel::takeBackPlace(const fact::PlaceChosen& before, const fact::PlaceChosen& chosen)
{
    SessionNode& node = m_session.node();
    const bool isUnderWay = isProposed<fact::PlaceChosen>(
        node, [&chosen](const fact::PlaceChosen& proposed) { return proposed == chosen; });
    proposeBack(node, m_station, before, isUnderWay ? QString{} : whyPlaceStays(before, chosen),
                m_history);
}

/// Empty where it can be taken back: a place is kept also for who has left.
QString PeopleModel::whyPlaceStays(const fact::PlaceChosen& before,
                                   const fact::PlaceChosen& chosen) const
{
    const auto state = m_session.node().state();
    const QString who = participantWord(*state, chosen.participant);
    const Angle now = state->participants().at(chosen.participant).turn;
    if (now == before.turn)
        return tr("Nothing to undo: %1 is seen where they were again.").arg(who);
    return now == chosen.turn ? QString{}
                              : tr("Not undone: somebody has placed %1 elsewhere since.").arg(who);
}

} // namespace carina
