#include "models/station/people_poses.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

/// The object of this kind with which a participant works: of several the first that they shared
/// themselves, before any that was handed to them.
ObjectId toolOfWork(const SessionState& state, StationId station, ParticipantId worker,
                    ObjectKind kind)
{
    const auto first = [&](bool isTheirs) {
        const auto found = std::ranges::find_if(state.objects(), [&](const auto& entry) {
            const SharedObject& object = entry.second;
            return object.owner == worker && object.station == station && object.kind == kind
                   && (object.sharer == worker) == isTheirs;
        });
        return found == state.objects().end() ? ObjectId{} : found->first;
    };
    const ObjectId theirs = first(true);
    return theirs == ObjectId{} ? first(false) : theirs;
}

/// Whether an object stays with the patient where its owner is drawn elsewhere.
bool staysWithPatient(ObjectKind kind, bool ownerIsAtWork)
{
    switch (kind) {
    case ObjectKind::Tube:
    case ObjectKind::Hand:
    case ObjectKind::Laryngoscope:
        return ownerIsAtWork;
    case ObjectKind::Jaw:
    case ObjectKind::Patient:
    case ObjectKind::OrganGroup:
    case ObjectKind::SpareTube:
    case ObjectKind::View:
    case ObjectKind::Pointer:
        return true;
    case ObjectKind::Head:
    case ObjectKind::Stylus:
        break;
    }
    return false;
}

std::optional<PoseSample> poseOf(const SessionNode& node, const SharedObject& object,
                                 const ObjectPoses& own, SessionTime t)
{
    if (object.owner == node.self())
        return own.isCalled(object.kind, object.name) ? own.at(object.kind, t) : std::nullopt;
    const auto poses = node.object(object.id);
    return poses ? poses->at(t) : std::nullopt;
}

} // namespace

std::vector<PersonPose> peoplePoses(const SessionNode& node, StationId station,
                                    const ObjectPoses& own, SessionTime t)
{
    const auto state = node.state();
    const ParticipantId worker = state->atWork(station);
    const std::array tools{toolOfWork(*state, station, worker, ObjectKind::Tube),
                           toolOfWork(*state, station, worker, ObjectKind::Jaw)};
    std::vector<PersonPose> people;
    for (const auto& [id, object] : state->objects()) {
        if (object.station != station || isActedOn(object.kind))
            continue;
        const auto owner = state->participants().find(object.owner);
        if (owner == state->participants().end() || !owner->second.present)
            continue;
        const auto pose = poseOf(node, object, own, t);
        if (!pose)
            continue;
        const bool isPlaced = !staysWithPatient(object.kind, object.owner == worker);
        people.push_back(
            {.object = id,
             .owner = object.owner,
             .ownerName = owner->second.name,
             .name = object.name,
             .kind = object.kind,
             .isOwn = object.owner == node.self(),
             .isAtWork = std::ranges::find(tools, id) != tools.end(),
             .pose = *pose,
             .X_AO = isPlaced ? placedBy(owner->second.turn) * pose->X_FO : pose->X_FO});
    }
    return people;
}

const PersonPose* atWork(const std::vector<PersonPose>& people, ObjectKind kind)
{
    const auto found = std::ranges::find_if(people, [kind](const PersonPose& person) {
        return person.isAtWork && person.kind == kind;
    });
    return found == people.end() ? nullptr : &*found;
}

const PersonPose* headOf(const std::vector<PersonPose>& people, ParticipantId participant)
{
    const auto found = std::ranges::find_if(people, [participant](const PersonPose& person) {
        return person.owner == participant && person.kind == ObjectKind::Head;
    });
    return found == people.end() ? nullptr : &*found;
}

RigidTransform placedBy(Angle turn)
{
    return {rotationFromVector(turn.si * Vec3::UnitY()), Vec3::Zero()};
}

} // namespace carina
