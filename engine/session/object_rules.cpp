#include "engine/session/object_rules.h"

#include "engine/anatomy/organ_group.h"
#include "engine/session/facts/plain_name.h"
#include "engine/session/participant_limits.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr ParticipantId kHostOfObjects{0};

template <class Wanted> std::size_t countObjects(const SessionState& state, Wanted wanted)
{
    return std::size_t(std::ranges::count_if(
        state.objects(), [&wanted](const auto& entry) { return wanted(entry.second); }));
}

Result<void> checkKnown(const SessionState& state, ObjectId id)
{
    if (!state.objects().contains(id))
        return fail(Errc::OutOfRange, "object " + std::to_string(id.value));
    return {};
}

/// @param counts which objects fill a participant's room; what can be lifted out does not
template <class Counts>
Result<void> checkRoom(const SessionState& state, const Participant& who, ObjectKind kind,
                       const Counts& counts)
{
    const auto fills = [&](const SharedObject& object) {
        return !isLiftable(object.kind) && counts(object);
    };
    const std::size_t ofKind = countObjects(
        state, [&](const SharedObject& object) { return object.kind == kind && fills(object); });
    const bool isFull = countObjects(state, fills) >= mostObjectsOf(who.role)
                        || (who.role == Role::Trainee && ofKind >= kMostOfAKind);
    return isFull ? fail(Errc::NotPermitted, "no more objects of this kind") : Result<void>{};
}

bool isWantedBy(const SharedObject& object, ParticipantId who)
{
    return std::ranges::find(object.wantedBy, who) != object.wantedBy.end();
}

/// Whether an instructor may be given one more of what others have shared.
Result<void> checkGiven(const SessionState& state, const Participant& instructor)
{
    const std::size_t given = countObjects(state, [&](const SharedObject& other) {
        return other.owner == instructor.id && other.sharer != instructor.id
               && !isLiftable(other.kind);
    });
    return given >= kMostGiven ? fail(Errc::NotPermitted, instructor.name) : Result<void>{};
}

/// An instructor who takes an object, or has asked for it, is not kept from it by what others have
/// given them.
Result<void> checkRoomForTools(const SessionState& state, const Participant& who,
                               const SharedObject& object, ParticipantId giver)
{
    const bool instructs = who.role == Role::Instructor;
    if (instructs && (giver == who.id || isWantedBy(object, who.id)))
        return {};
    const auto author = state.participants().find(giver);
    const bool isUnasked = instructs && author != state.participants().end()
                           && author->second.role != Role::Instructor;
    return checkRoom(state, who, object.kind,
                     [&](const SharedObject& other) {
                         return other.owner == who.id && other.id != object.id;
                     })
        .and_then([&] { return isUnasked ? checkGiven(state, who) : Result<void>{}; });
}

Result<void> checkRoomToHold(const SessionState& state, const Participant& who,
                             const SharedObject& object, ParticipantId giver)
{
    if (!isLiftable(object.kind))
        return checkRoomForTools(state, who, object, giver);
    if (who.role != Role::Trainee || object.kind != ObjectKind::OrganGroup)
        return {};
    const std::size_t held = countObjects(state, [&](const SharedObject& other) {
        return other.owner == who.id && other.kind == ObjectKind::OrganGroup;
    });
    return held >= kMostGroupsHeld ? fail(Errc::NotPermitted, who.name) : Result<void>{};
}

Result<void> checkNewOwner(const SessionState& state, const SharedObject& object, ParticipantId id)
{
    const auto owner = state.participants().find(id);
    if (owner == state.participants().end() || (isLiftable(object.kind) && !owner->second.present))
        return fail(Errc::OutOfRange, "participant " + std::to_string(id.value));
    const Participant& person = owner->second;
    const bool isElsewhere = person.role == Role::Trainee && person.station != object.station;
    if (person.role == Role::Observer || isElsewhere)
        return fail(Errc::NotPermitted, person.name);
    return {};
}

Result<void> checkLiftable(const SessionState& state, StationId station,
                           const fact::ObjectShared& shared)
{
    if (shared.kind == ObjectKind::OrganGroup && !groupFromName(shared.name))
        return fail(Errc::OutOfRange, "a group of organs named " + shared.name);
    const std::size_t there = countObjects(state, [station](const SharedObject& object) {
        return object.station == station && isLiftable(object.kind);
    });
    if (there >= kMostLiftables)
        return fail(Errc::NotPermitted, "no more objects to lift out");
    return {};
}

} // namespace

Result<void> checkShared(const SessionState& state, StationId station,
                         const fact::ObjectShared& shared)
{
    if (state.objects().contains(shared.object))
        return {};
    if (isLiftable(shared.kind))
        return checkLiftable(state, station, shared);
    const auto owner = state.participants().find(shared.owner);
    if (shared.owner == kHostOfObjects || owner == state.participants().end())
        return {}; // one who is not there is refused by who may share what
    const auto isSharedBy = [&shared](const SharedObject& object) {
        return object.sharer == shared.owner;
    };
    return checkRoom(state, owner->second, shared.kind, isSharedBy).and_then([&shared] {
        return checkName(shared.name);
    });
}

Result<void> checkHandOver(const SessionState& state, ParticipantId author,
                           const fact::ObjectHandedOver& handed)
{
    if (const auto known = checkKnown(state, handed.object); !known)
        return known;
    const SharedObject& object = state.objects().at(handed.object);
    const bool isPutBack = handed.owner == kNobody && isLiftable(object.kind);
    if (!isPutBack)
        if (const auto may = checkNewOwner(state, object, handed.owner); !may)
            return may;
    if (object.epoch != handed.epoch || (isPutBack && object.owner == kNobody))
        return fail(Errc::OwnerChanged, object.name);
    return isPutBack
               ? Result<void>{}
               : checkRoomToHold(state, state.participants().at(handed.owner), object, author);
}

Result<void> checkWish(const SessionState& state, const fact::ObjectWanted& wanted)
{
    if (const auto known = checkKnown(state, wanted.object); !known)
        return known;
    const SharedObject& object = state.objects().at(wanted.object);
    return object.owner == kNobody ? fail(Errc::OwnerChanged, object.name) : Result<void>{};
}

bool mayPassOn(const SessionState& state, const Participant& trainee,
               const fact::ObjectHandedOver& handed)
{
    const SharedObject& object = state.objects().at(handed.object);
    if (object.owner == kNobody)
        return handed.owner == trainee.id && object.station == trainee.station;
    if (object.owner != trainee.id)
        return false;
    if (handed.owner == kNobody || handed.owner == trainee.id)
        return true;
    return state.participants().at(handed.owner).role == Role::Instructor
           || isWantedBy(object, handed.owner);
}

} // namespace carina
